#include "iga/post/stress_measures.hpp"

#include <Eigen/LU>
#include <limits>

#include "geometry/base/dense_matrices.hpp"

namespace isopatch::iga {

PrincipalStresses principal_stresses(const Eigen::Matrix3d& stress) {
  const PrincipalAxes found = principal_axes(stress);
  PrincipalStresses result{found.values.reverse(), found.axes.rowwise().reverse()};
  if (result.directions.determinant() < 0) result.directions.col(2) *= -1;
  return result;
}

Eigen::Vector3d principal_values(const Eigen::Matrix3d& stress) {
  return principal_axes(stress).values.reverse();
}

double tresca(const Eigen::Matrix3d& stress) {
  const Eigen::Vector3d values = principal_values(stress);
  return values[0] - values[2];
}

double safety_factor(double von_mises, double yield) {
  return von_mises > 0 ? yield / von_mises : std::numeric_limits<double>::infinity();
}

}  // namespace isopatch::iga
