#pragma once

#include <Eigen/Core>

namespace isopatch::geometry {

/// Nodes and weights on [0, 1], exact for polynomials of degree 2n - 1.
struct QuadratureRule {
  Eigen::VectorXd nodes;
  Eigen::VectorXd weights;
};

/// @param points  n in 1 .. 64
/// @source  Golub, Welsch 1969
QuadratureRule gauss_legendre(int points);

}  // namespace isopatch::geometry
