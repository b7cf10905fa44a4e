#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/splines/knot_vector.hpp"
#include "segmentation/parameterization/internal/rational_net.hpp"

namespace isopatch::segmentation {

/// The net of the transfinite blend of a surface's boundary. Control points at the boundary stay as they are,
/// to the last bit; the inner ones are those of the exact blend, because (1 - s) has its Greville shares as
/// coefficients.
/// @param net    (3, product of sizes); inner points are not looked at
/// @source Farin, Hansford, Discrete Coons patches, CAGD 1999
Eigen::Matrix3Xd coons_net(const std::array<geometry::KnotVector, 2>& knots, Eigen::Matrix3Xd net);

/// The same of a volume: three blends of faces less three blends of edges plus the blend of the corners.
Eigen::Matrix3Xd coons_net(const std::array<geometry::KnotVector, 3>& knots, Eigen::Matrix3Xd net);

/// The same of rational boundaries, in homogeneous coordinates: a blend of coplanar curves is plane, rulings
/// stay rulings. All weights are 1 where those of the boundary are.
///
/// Weights may come out too small to work with: `has_fair_weights` tells.
RationalNet coons_net(const std::array<geometry::KnotVector, 2>& knots, RationalNet net);
RationalNet coons_net(const std::array<geometry::KnotVector, 3>& knots, RationalNet net);

}  // namespace isopatch::segmentation
