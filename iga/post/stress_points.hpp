#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "geometry/splines/nurbs.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// A largest value and where it is.
struct Extremum {
  double value = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< undeformed, m
  int patch = -1;
  geometry::Parameter<3> parameter = geometry::Parameter<3>::Zero();
};

/// Relative difference up to which two values count as equal: round-off, not the model, makes one the larger.
constexpr double same_value = 1e-9;
/// A NaN is larger than any number, so that none is forgotten.
inline bool is_larger(double value, double other) {
  const bool is_first_nan = value != value && other == other;
  return is_first_nan || value > other + same_value * (other < 0 ? -other : other);
}

/// The larger of two; of equal ones that of the smaller patch, then of the smaller parameter, the third
/// direction first.
Extremum larger(const Extremum& a, const Extremum& b);
/// The largest over all processes; all get it.
Extremum largest(const Extremum& extremum, const solvers::Processes& processes);

/// Below this scaled Jacobian (the determinant over the product of its columns' lengths) a map counts as
/// folded: a stress through it is more than a hundred times the displacement's own gradient and says nothing.
constexpr double least_scaled_jacobian = 0.01;

/// Whether the map of a patch is regular at a point, so that a stress there is meaningful.
enum class MapState {
  sound,
  folded,     ///< the scaled Jacobian is below `least_scaled_jacobian`
  collapsed,  ///< a column vanishes, as on collapsed edges and faces
};
/// Classifies a point by its Jacobian.
/// @param scaled  receives the scaled Jacobian, 0 where a column vanishes
MapState map_state(const Eigen::Matrix3d& jacobian, double& scaled);

/// Points left out of the search for the largest stress, because the map is not regular there.
struct LeftOut {
  std::int64_t folded = 0;
  std::int64_t collapsed = 0;
  /// The worst of the folded points: `value` is minus its scaled Jacobian; in no patch if there is none.
  Extremum worst = {-2, Eigen::Vector3d::Zero(), -1, geometry::Parameter<3>::Zero()};
};
LeftOut together(const LeftOut& a, const LeftOut& b);
/// Combines the counts of all processes; all get the result.
LeftOut summed(const LeftOut& share, const solvers::Processes& processes);

/// Refuses a stress that is no finite number.
/// @throws Error singular_system  naming patch and place: a stress that is no finite number
void require_finite(double stress, int patch, const Eigen::Vector3d& place);

}  // namespace isopatch::iga
