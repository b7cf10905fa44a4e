#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <type_traits>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// Values of all basis functions (or their derivatives) at many parameters: (parameters, basis functions).
/// @param order  of the derivative
/// @cost         O(parameters * degree^2)
Eigen::SparseMatrix<double, Eigen::RowMajor> collocation(const KnotVector& knots,
                                                         const std::vector<double>& parameters,
                                                         int order = 0);

/// The parameters of a grid along each direction.
template <int D>
using GridParameters = std::array<std::vector<double>, static_cast<std::size_t>(D)>;

/// Points of a spline on the grid of the given parameters, first direction fastest. (3, product of their
/// counts). Much cheaper than point by point: one product per direction.
template <int D>
Eigen::Matrix3Xd points_on_grid(const Nurbs<D>& spline,
                                const std::type_identity_t<GridParameters<D>>& parameters);

}  // namespace isopatch::geometry
