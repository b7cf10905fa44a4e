#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isopatch::geometry {

/// A field on Bezier cells.
struct BezierField {
  std::string name;
  /// (components, points): coefficients in the cells' rational Bernstein basis, the same that carries the
  /// points; as a cell field (components, cells): one value per cell.
  Eigen::MatrixXd values;
};

/// Rational Bezier hexahedra of one degree that share no points.
struct BezierCells {
  std::array<int, 3> degree = {1, 1, 1};  ///< 1 .. 20 per direction
  /// (3, n), model units, not multiplied by the weights: each cell owns (p1+1)(p2+1)(p3+1) consecutive
  /// points, first direction fastest.
  Eigen::Matrix3Xd points;
  Eigen::VectorXd weights;  ///< (n), positive; empty: all equal
  int cell_count = 0;
  std::vector<BezierField> point_fields;
  std::vector<BezierField> cell_fields;
};

/// Takes a file's bytes, from the first to the last.
using ByteSink = std::function<void(std::string_view)>;

/// How places and fields are stored: 8 bytes a number, or 4 with a relative error of 6e-8.
enum class Precision { full, single };

/// Writes an unstructured grid file (.vtu) of VTK_BEZIER_HEXAHEDRON cells, as ParaView 5.9 and later read it,
/// piece by piece: one piece is in memory at a time.
///
/// Not compressed: zlib saved a third to a half of the bytes and took most of the time of a run's output;
/// single precision saves half of them. Points and fields in full precision are exact: VTK evaluates the same
/// rational polynomials.
///
/// @param piece_cells  number of cells of each piece
/// @param piece        cells of a piece, asked for in order; all with the degree and the fields of the first,
/// with
///                     weights in all or in none
/// @param sink         takes the file's bytes
/// @throws Error invalid_argument  sizes that do not fit each other, a weight that is not positive, a value
/// that is not
///                                 finite, a field name that is empty, used twice or one of VTK's own
///                                 (RationalWeights, HigherOrderDegrees)
/// @cost    O(n), about 0.05 us per point
/// @source  VTK 9.1: vtkBezierHexahedron, vtkHigherOrderHexahedron::PointIndexFromIJK; VTK XML format,
/// appended raw data
void write_vtu(const std::vector<int>& piece_cells, const std::function<BezierCells(std::size_t)>& piece,
               const ByteSink& sink, Precision precision = Precision::full);

/// The same for cells in one piece.
/// @return  the file's content, for isopatch::write_file
std::string to_vtu(const BezierCells& cells, Precision precision = Precision::full);

/// A multi-block file (.vtm) that opens several files as one model.
/// @param blocks  name of each block and its file, relative to the folder of the collection
/// @throws Error invalid_argument  for an absolute path, which would not survive a move of the folder
std::string to_vtm(const std::vector<std::pair<std::string, std::string>>& blocks);

}  // namespace isopatch::geometry
