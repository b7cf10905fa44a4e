#include "geometry/quadrature.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::geometry {

QuadratureRule gauss_legendre(int points) {
  if (points < 1 || points > 64)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} Gauss points per direction are outside 1 .. 64", points));
  Eigen::VectorXd off_diagonal(points - 1);
  for (int k = 1; k < points; ++k) off_diagonal[k - 1] = k / std::sqrt(4.0 * k * k - 1);
  const SymmetricEigen eigen = tridiagonal_eigen(Eigen::VectorXd::Zero(points), off_diagonal);
  const Eigen::VectorXd nodes = 0.5 * (eigen.values.array() + 1);
  return {nodes, eigen.vectors.row(0).cwiseAbs2().transpose()};
}

}  // namespace isopatch::geometry
