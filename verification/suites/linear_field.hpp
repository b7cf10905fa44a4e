#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "geometry/base/larger.hpp"
#include "iga/problem/problem.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::verification {

/// u = shift + gradient x: contained in every isogeometric space, with constant stress.
struct LinearField {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< m
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return shift + gradient * x; }
  Eigen::Matrix3d strain() const { return 0.5 * (gradient + gradient.transpose()); }
  Eigen::Matrix3d stress(const iga::Material& material) const { return iga::stress(strain(), material); }
  /// J/m^3
  double energy_density(const iga::Material& material) const {
    return 0.5 * stress(material).cwiseProduct(strain()).sum();
  }
  iga::PrescribedDisplacement prescribed() const { return {{shift[0], shift[1], shift[2]}, gradient}; }
};

/// Strains in all directions and a rotation, none of them equal.
inline LinearField generic_linear_field() {
  LinearField field;
  field.shift << 1e-3, -2e-3, 5e-4;
  field.gradient << 1e-3, 4e-4, -2e-4, 3e-4, -5e-4, 1e-4, -1e-4, 6e-4, 8e-4;
  return field;
}

/// Largest difference of a coefficient from that of the linear field, relative to the largest one.
inline double coefficient_error(const iga::ElasticField& field, const LinearField& exact) {
  double error = 0;
  double size = 0;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const Eigen::Matrix3Xd u = (exact.gradient * field.patches[p].control_points()).colwise() + exact.shift;
    error = larger(error, (field.displacement[p] - u).colwise().norm().maxCoeff<Eigen::PropagateNaN>());
    size = larger(size, u.colwise().norm().maxCoeff<Eigen::PropagateNaN>());
  }
  return error / size;
}

/// Largest difference of the coefficients of two fields in one space, the second one turned first, relative
/// to the largest of the first.
inline double coefficient_difference(const iga::ElasticField& a, const iga::ElasticField& b,
                                     const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity()) {
  double apart = 0;
  double size = 0;
  for (std::size_t p = 0; p < a.displacement.size(); ++p) {
    apart = larger(
        apart,
        (a.displacement[p] - rotation * b.displacement[p]).colwise().norm().maxCoeff<Eigen::PropagateNaN>());
    size = larger(size, a.displacement[p].colwise().norm().maxCoeff<Eigen::PropagateNaN>());
  }
  return apart / size;
}

}  // namespace isopatch::verification
