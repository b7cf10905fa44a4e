#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "iga/internal/tensor_contraction.hpp"
#include "iga/output/internal/grid_line.hpp"

namespace isopatch::iga {

/// Geometry and displacement of a patch on a grid, plane by plane of direction 3, row by row, point by point:
/// eight fields (x w, y w, z w, w, u w, v w, w w, 0) of numerators and their derivatives. Nothing is ever in
/// memory but two planes of the patch's coefficients.
class GridSums {
 public:
  /// @param patch         must outlive this, as must
  /// @param displacement  its coefficients
  GridSums(const geometry::NurbsVolume& patch, const Eigen::Matrix3Xd& displacement,
           std::array<GridLine, 3> lines)
      : patch_(patch), displacement_(displacement), lines_(std::move(lines)) {}

  const GridLine& line(std::size_t d) const { return lines_[d]; }
  std::array<int, 3> sizes() const { return {lines_[0].size(), lines_[1].size(), lines_[2].size()}; }

  /// Direction 3 summed: eight fields for each pair of functions of directions 1 and 2.
  struct Plane {
    std::vector<FieldLanes<8>> value, d3;
  };
  /// @param combination  of direction 3
  /// @cost  O(degree) per coefficient of the plane; in parallel
  void plane(int combination, Plane& out) const;

  /// Direction 2 summed as well: eight fields for each function of direction 1.
  struct Row {
    std::vector<FieldLanes<8>> value, d2, d3;
  };
  void row(int combination, const Plane& plane, Row& out) const;

  /// Direction 1 summed as well: values and derivatives along the three directions.
  struct Point {
    FieldLanes<8> value, d1, d2, d3;
  };
  Point point(int combination, const Row& row) const {
    const GridLine& line = lines_[0];
    const auto from = static_cast<std::size_t>(line.first[static_cast<std::size_t>(combination)]);
    Point p{FieldLanes<8>::Zero(), FieldLanes<8>::Zero(), FieldLanes<8>::Zero(), FieldLanes<8>::Zero()};
    for (Eigen::Index a = 0; a < line.values.cols(); ++a) {
      const double value = line.values(combination, a);
      const auto i = from + static_cast<std::size_t>(a);
      p.value += value * row.value[i];
      p.d1 += line.derivatives(combination, a) * row.value[i];
      p.d2 += value * row.d2[i];
      p.d3 += value * row.d3[i];
    }
    return p;
  }

 private:
  const geometry::NurbsVolume& patch_;
  const Eigen::Matrix3Xd& displacement_;
  std::array<GridLine, 3> lines_;
};

}  // namespace isopatch::iga
