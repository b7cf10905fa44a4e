#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace isopatch::geometry {

/// det J divided by the product of its columns' lengths: 1 for a brick, <= 0 for a fold; 0 where a column
/// vanishes.
inline double scaled_jacobian(const Eigen::Matrix3d& jacobian) {
  const double lengths = jacobian.colwise().norm().prod();
  return lengths > 0 ? jacobian.determinant() / lengths : 0;
}

}  // namespace isopatch::geometry
