#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "iga/post/stress_peaks.hpp"
#include "iga/post/stress_points.hpp"
#include "iga/problem/unresolved_energy.hpp"

namespace isopatch::iga {

/// The interface force at two coincident control points: the first exerts `force` on the second.
/// Without the components that supports fix; pairs with all components fixed have none.
struct Multiplier {
  int first_node = 0;
  int second_node = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N
};

struct Reaction {
  std::string support;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< on the part, N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the origin, N m

  /// About another point, N m.
  Eigen::Vector3d moment_about(const Eigen::Vector3d& point) const { return moment - point.cross(force); }
};

struct ElasticityResults {
  Extremum max_displacement;  ///< length of the displacement, m; on a grid of degree + 1 points per element
                              ///< and direction, ends included
  Extremum max_von_mises;     ///< Pa; of the Gauss points and of a grid on the faces of all patches
  StressPeaks peaks;          ///< of the same points as `max_von_mises`
  LeftOut left_out;           ///< points that `max_von_mises` does not look at
  Extremum max_strain;        ///< Frobenius norm of the strain; at the Gauss points that are not left out
  UnresolvedEnergy unresolved;
  std::vector<std::string> idle_loads;  ///< surface loads that act where supports take them all
  double internal_energy = 0;           ///< half the integral of stress : elastic strain, J
  double support_energy = 0;            ///< in the springs of elastic supports, J
  double interface_energy = 0;  ///< of what couples non-matching interfaces, J; of either sign, small where
                                ///< the jumps are
  double thermal_work = 0;  ///< minus half the integral of stress : thermal strain, J; with external_work the
                            ///< energy of part and supports
  double external_work = 0;  ///< half the work of loads and of reactions on prescribed displacements, J
  std::vector<Reaction> reactions;                       ///< one per support
  Eigen::Vector3d total_load = Eigen::Vector3d::Zero();  ///< N
  double load_size = 0;  ///< sum of the lengths of all nodal loads, N: what an imbalance is held against
};

struct PhaseTime {
  std::string phase;
  double seconds = 0;
};

}  // namespace isopatch::iga
