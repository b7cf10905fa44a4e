#include "iga/post/stress_points.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/scaled_jacobian.hpp"

namespace isopatch::iga {
namespace {

bool comes_first(const Extremum& a, const Extremum& b) {
  if (a.patch != b.patch) return a.patch < b.patch;
  for (const int d : {2, 1, 0})
    if (a.parameter[d] != b.parameter[d]) return a.parameter[d] < b.parameter[d];
  return true;
}

// Below this share of the longest column a column vanishes.
constexpr double vanishing = 1e-8;

}  // namespace

Extremum larger(const Extremum& a, const Extremum& b) {
  if (a.patch < 0 || b.patch < 0) return a.patch < 0 ? b : a;
  if (is_larger(a.value, b.value)) return a;
  if (is_larger(b.value, a.value)) return b;
  return comes_first(a, b) ? a : b;
}

Extremum largest(const Extremum& extremum, const solvers::Processes& processes) {
  struct Plain {
    double value;
    int patch;
    double place[3], parameter[3];
  };
  const auto& [value, place, patch, parameter] = extremum;
  const Plain mine{value, patch, {place[0], place[1], place[2]}, {parameter[0], parameter[1], parameter[2]}};
  Extremum best;
  for (int rank = 0; rank < processes.count(); ++rank) {
    const Plain other = processes.from(rank, mine);
    const Extremum theirs{other.value, Eigen::Map<const Eigen::Vector3d>(other.place), other.patch,
                          Eigen::Map<const Eigen::Vector3d>(other.parameter)};
    best = rank == 0 ? theirs : larger(best, theirs);
  }
  return best;
}

MapState map_state(const Eigen::Matrix3d& jacobian, double& scaled) {
  const Eigen::RowVector3d lengths = jacobian.colwise().norm();
  scaled = 0;
  if (!(lengths.minCoeff() > vanishing * lengths.maxCoeff())) return MapState::collapsed;
  scaled = geometry::scaled_jacobian(jacobian);
  return scaled >= least_scaled_jacobian ? MapState::sound : MapState::folded;
}

LeftOut together(const LeftOut& a, const LeftOut& b) {
  return {a.folded + b.folded, a.collapsed + b.collapsed, larger(a.worst, b.worst)};
}

LeftOut summed(const LeftOut& share, const solvers::Processes& processes) {
  if (processes.count() == 1) return share;
  return {processes.sum(share.folded), processes.sum(share.collapsed), largest(share.worst, processes)};
}

void require_finite(double stress, int patch, const Eigen::Vector3d& place) {
  if (std::isfinite(stress)) return;
  throw Error(ErrorCode::singular_system,
              fmt::format("the stress in patch {} at ({:.6g}, {:.6g}, {:.6g}) m is not a finite number: the "
                          "solution is none; look at the supports, the materials' constants and the size of "
                          "loads and factors",
                          patch, place[0], place[1], place[2]));
}

}  // namespace isopatch::iga
