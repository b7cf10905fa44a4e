#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>

#include "geometry/splines/grid.hpp"

namespace isopatch::geometry {

/// A line of a grid of parameters along the second direction: first derivatives of a volume, one (n, 3) array
/// for each direction, model units per parameter.
struct JacobianLine {
  int first = 0;  ///< index of the grid's parameter in the first direction
  int third = 0;  ///< and in the third
  std::array<Eigen::ArrayX3d, 3> columns;

  /// det J at each point of the line.
  Eigen::ArrayXd determinants() const;
  /// The product of the columns' squared lengths.
  Eigen::ArrayXd squared_lengths() const;
};

/// Calls `visit` for every line of a grid, third direction slowest.
///
/// Sums are done one direction after the other, on long rows: many times faster than point by point.
/// @param parameters  increasing along each direction
/// @cost  O(points * degree), and memory for one layer of the grid
void for_each_line(const NurbsVolume& volume, const GridParameters<3>& parameters,
                   const std::function<void(const JacobianLine&)>& visit);

}  // namespace isopatch::geometry
