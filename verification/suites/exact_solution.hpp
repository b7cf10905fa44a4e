#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "iga/spaces/elastic_field.hpp"

namespace isopatch::verification {

/// A displacement that is known everywhere.
struct ExactSolution {
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> displacement;  ///< m
  std::function<Eigen::Matrix3d(const Eigen::Vector3d&)> gradient;      ///< row i: derivatives of component i
};

/// Errors of a field over all patches, relative to the exact solution's own norms.
struct Errors {
  double displacement = 0;  ///< in L2
  double energy = 0;        ///< in the energy norm
};

/// @param points  Gauss points per element and direction, more than assembly takes
Errors errors(const iga::ElasticField& field, const ExactSolution& exact, int points);

/// The stress that goes with a displacement gradient, Pa.
Eigen::Matrix3d stress_of(const Eigen::Matrix3d& gradient, const iga::Material& material);

}  // namespace isopatch::verification
