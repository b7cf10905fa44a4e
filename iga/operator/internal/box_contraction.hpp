#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "iga/internal/lanes.hpp"
#include "iga/operator/internal/line_table.hpp"

namespace isopatch::iga {

/// The elements that one sum factorization covers: a box in directions 2 and 3, in direction 1 bands of eight
/// Gauss points.
struct ElementBox {
  std::array<int, 3> begin;
  std::array<int, 3> end;
};

/// The functions of a patch that live in a box, a grid of their own, direction 1 fastest.
struct BoxFunctions {
  std::array<int, 3> first;
  std::array<int, 3> sizes;
  std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(sizes[0]) * sizes[1] * sizes[2]; }
};

/// One product of a stage: of each function (or point) the fields from .. from + count - 1, multiplied by the
/// table `kind`, give the fields from `to` on of each point (or function).
struct ContractionStep {
  int from;
  int count;
  int kind;
  int to;
};

/// How many fields each stage of a sum factorization keeps, and the products between the stages. A field is
/// eight points of direction 1; it is kept per pair of functions of directions 2 and 3 (plane), per function
/// of direction 2 and point of direction 3 (row), and per pair of points.
struct ContractionStages {
  int plane = 0;
  int row = 0;
  int point = 0;
  std::vector<ContractionStep> middle;  ///< between planes and rows, along direction 3
  std::vector<ContractionStep> last;    ///< between rows and points, along direction 2
};

/// The stages from coefficients to derivatives at the points. A plane has the values V of all fields and
/// their derivatives D1, a row V, D1, D3, a point V (if asked for), D1, D3, D2.
ContractionStages field_stages(int fields, bool values);

/// The stages from forces at the points, which multiply D1, D3, D2 (and V) of the test functions, to three
/// sums per function: the transpose of field_stages(fields, values), with three fields for each displacement.
ContractionStages force_stages(bool values, int fields = 3);

/// The stages from the points to the integrals of products of two derivatives of the same function, for
/// diagonal blocks: kind (i, j), i <= j, in 1 .. 3 or, with values, 0 .. 3, has six vectors at a point, in
/// the order of square_kinds. Tables are `squares`.
ContractionStages square_stages(bool values);
/// The kinds in their order.
std::vector<std::array<int, 2>> square_kinds(bool values);

/// Sum factorization over a box of elements, band by band: its buffers, and the stages along directions 2 and
/// 3 in both senses.
///
/// All lines of a stage are worked on together, eight points of direction 1 at a time, so that no element
/// is ever looked at by itself before the points.
/// @cost    per point 2 (degree + 1) flops for each vector of `last`, and 1/points, 1/points^2 of that before
/// @source  Orszag 1980; patch-wise: Sangalli, Tani, arXiv 1712.08565, section 4
class BoxContraction {
 public:
  /// Turns to another box; storage is used again. Tables, of directions 2 and 3, must outlive this.
  void start(const LineTable& direction2, const LineTable& direction3, const ContractionStages& stages,
             const ElementBox& box);

  /// Functions of directions 2 and 3 that live in the box.
  int first_row() const { return first_row_; }
  int rows() const { return rows_; }
  int first_plane() const { return first_plane_; }
  int planes() const { return planes_count_; }
  /// Vectors of a pair of functions, counted from the first ones.
  Lanes* plane(int row, int plane) {
    return planes_.data() + (static_cast<std::ptrdiff_t>(plane) * rows_ + row) * stages_->plane;
  }
  /// Vectors of a point of the element last worked on.
  Lanes* point(int q2) { return points_.data() + static_cast<std::ptrdiff_t>(q2) * stages_->point; }

  /// Forwards: planes to the rows of an element of direction 3, then rows to the points of an element of
  /// direction 2 at one of its points of direction 3.
  void expand_layer(int element3);
  void expand_points(int element2, int q3);

  /// Backwards, adding; the rows are cleared by clear_rows, the planes by clear_planes.
  void collect_points(int element2, int q3);
  void collect_layer(int element3);
  void clear_rows();
  void clear_planes();

 private:
  Lanes* row(int row, int q3) {
    return rows_buffer_.data() + (static_cast<std::ptrdiff_t>(q3) * rows_ + row) * stages_->row;
  }
  const LineTable* table2_ = nullptr;
  const LineTable* table3_ = nullptr;
  const ContractionStages* stages_ = nullptr;
  int first_row_ = 0, rows_ = 0, first_plane_ = 0, planes_count_ = 0;
  int points2_ = 0, points3_ = 0;  // of an element
  std::vector<Lanes> planes_, rows_buffer_, points_;
};

}  // namespace isopatch::iga
