#include "iga/post/stress_measures.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace isopatch::iga {

PrincipalStresses principal_stresses(const Eigen::Matrix3d& stress) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> found(stress);
  PrincipalStresses result{found.eigenvalues().reverse(), found.eigenvectors().rowwise().reverse()};
  if (result.directions.determinant() < 0) result.directions.col(2) *= -1;
  return result;
}

Eigen::Vector3d principal_values(const Eigen::Matrix3d& stress) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stress, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .reverse();
}

double tresca(const Eigen::Matrix3d& stress) {
  const Eigen::Vector3d values = principal_values(stress);
  return values[0] - values[2];
}

double safety_factor(double von_mises, double yield) {
  return von_mises > 0 ? yield / von_mises : std::numeric_limits<double>::infinity();
}

}  // namespace isopatch::iga
