#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geometry/io/byte_sink.hpp"

namespace isopatch::geometry {

/// How numbers are stored: 8 bytes each, or 4 with a relative error of 6e-8.
enum class Precision { full, single };

enum class VtuCell { quadrilateral, hexahedron, bezier_hexahedron };

/// A tensor grid of points, first direction fastest, with cells between them that share points.
struct VtuGrid {
  std::array<int, 3> points = {2, 2, 2};  ///< of quadrilaterals the third is 1
  /// Of Bezier cells, 1 .. 20: each has degree + 1 points along a direction and shares the last with the next
  /// one. Else 1.
  std::array<int, 3> degree = {1, 1, 1};
  bool turned = false;  ///< whether a quadrilateral's normal is the second direction times the first

  std::int64_t point_count() const;
  std::int64_t cell_count() const;
};

/// Numbers at the points: of Bezier cells, coefficients in the basis that carries the points.
struct VtuField {
  std::string name;
  int components = 1;
  Precision precision = Precision::single;
};

/// A whole number for each grid, which all its cells get.
struct VtuLabel {
  std::string name;
  std::vector<int> of_grid;
};

/// A number for each cell, in single precision.
struct VtuCellField {
  std::string name;
  /// The grid, and its cell, first direction fastest. Must be finite.
  std::function<float(std::size_t grid, std::int64_t cell)> value;
};

/// An unstructured grid file (.vtu) of tensor grids, for VTK and ParaView 5.9 or later, whose numbers come
/// in any order, so that no more than a part of them is ever in memory.
///
/// Not compressed: zlib saved a third to a half of the bytes and took most of the time of a run's output.
/// Fields named "RationalWeights" are the weights of Bezier cells.
///
/// @source  VTK 9.1: vtkHigherOrderHexahedron::PointIndexFromIJK; VTK XML format, appended raw data. The
/// file's version is 2.2; VTK takes those below 2.1 to list the points of an edge of a cell in another order.
class VtuFile {
 public:
  /// @param sink  takes the bytes; some 256 kB per field wait in memory
  /// @throws Error invalid_argument  no grid; a grid whose cells do not fit its points; a name that is empty
  ///   or used twice; a label without a value for each grid
  VtuFile(VtuCell cell, std::vector<VtuGrid> grids, std::vector<VtuField> fields,
          std::vector<VtuLabel> labels, PlacedByteSink sink, Precision places = Precision::full,
          std::vector<VtuCellField> cell_fields = {});
  ~VtuFile();
  VtuFile(VtuFile&&) = delete;

  /// Places of the points from `first` on, counted over all grids. (3, n), model units.
  /// @throws Error invalid_argument  a value that is not finite or too large for single precision, as below
  void points(std::int64_t first, const Eigen::Matrix3Xd& values);
  /// Numbers of a field at the points from `first` on. (components, n).
  void field(std::size_t index, std::int64_t first, const Eigen::MatrixXd& values);
  /// Writes what is left: the cells. All points and fields must have been given.
  /// @cost  O(points of all cells)
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isopatch::geometry
