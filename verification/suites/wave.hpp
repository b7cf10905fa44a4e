#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/material/material.hpp"
#include "verification/suites/exact_solution.hpp"

namespace isopatch::verification {

/// A plane n.x = offset.
struct Plane {
  Eigen::Vector3d normal = {1, 0, 0};
  double offset = 0;
};

/// A manufactured displacement: u = A x + product over the planes of (n.x - offset) * sin(a.x + phase) * c.
/// Linear on every plane, where it can be prescribed; smooth and not a polynomial elsewhere.
struct Wave {
  std::vector<Plane> planes = {};
  Eigen::Vector3d frequency = {1.1, 0.8, -0.6};
  double phase = 0;
  Eigen::Vector3d direction = {0.3, -0.5, 0.4};
  Eigen::Matrix3d linear =
      (Eigen::Matrix3d() << 0.10, 0.02, -0.03, 0.04, -0.05, 0.06, 0.07, -0.01, 0.03).finished();

  Eigen::Vector3d displacement(const Eigen::Vector3d& x) const;
  Eigen::Matrix3d gradient(const Eigen::Vector3d& x) const;
  /// -div sigma, the force per volume that goes with it.
  Eigen::Vector3d body_force(const Eigen::Vector3d& x, const iga::Material& material) const;

  ExactSolution exact() const;
};

}  // namespace isopatch::verification
