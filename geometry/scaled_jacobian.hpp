#pragma once

#include <Eigen/LU>

namespace isopatch::geometry {

/// det J over the product of the lengths of J's columns: 1 where parameter lines are orthogonal, 0 where a
/// map is singular, negative where it is folded.
/// @param jacobian  derivatives along the parameters as columns
/// @return  -1 .. 1; 0 where a column vanishes
inline double scaled_jacobian(const Eigen::Matrix3d& jacobian) {
  const double lengths = jacobian.colwise().norm().prod();
  return lengths > 0 ? jacobian.determinant() / lengths : 0;
}

}  // namespace isopatch::geometry
