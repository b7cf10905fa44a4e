#pragma once

#include <Eigen/Geometry>

#include "iga/problem/loads.hpp"

namespace isopatch::iga::testing {

struct Resultant {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // about the origin
};

/// Of all loads of a problem. Rigid motions have the control points' own displacements as coefficients, so
/// this is the work on them.
inline Resultant resultant(const ElasticityProblem& p, int points = 0) {
  const Eigen::Matrix3Xd load = load_vector(p, points);
  const Discretization& d = p.discretization;
  Resultant result;
  for (std::size_t patch = 0; patch < d.patches.size(); ++patch)
    for (int i = 0; i < d.patches[patch].size(); ++i) {
      const Eigen::Vector3d force = load.col(d.first_node[patch] + i);
      result.force += force;
      result.moment += Eigen::Vector3d(d.patches[patch].control_points().col(i)).cross(force);
    }
  return result;
}

}  // namespace isopatch::iga::testing
