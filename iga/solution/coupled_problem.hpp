#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/coupling/coupling_kind.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/coupling/supported_system.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/problem/problem.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// An elasticity problem whose patches are tied and whose supports and loads are discrete: all that a way to
/// solve needs. The same on every process but for `parts`.
struct CoupledProblem {
  const ElasticityProblem* problem = nullptr;  ///< must outlive this
  Coupling coupling = Coupling::elimination;
  int points = 0;  ///< Gauss points per element and direction; 0: what suits each space
  solvers::Processes processes;
  GlobalNodes global;
  std::vector<SupportFrame> frames;  ///< one per global node
  std::vector<MultiplierRow> multipliers;
  Eigen::Matrix3Xd load;               ///< per node, those of temperatures included, (3, nodes), N
  std::vector<ThermalStrain> thermal;  ///< one per patch, or none
  Eigen::Matrix3Xd thermal_load;       ///< share of `load` that temperatures cause; empty without
  std::vector<PatchSpace> spaces;
  Distribution distribution;
  std::vector<PatchLayers> parts;  ///< what this process integrates

  const Discretization& discretization() const { return problem->discretization; }
  const SupportFrame& frame_of(int node) const {
    return frames[static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(node)])];
  }
};

/// Numbers the nodes globally, discretizes supports and loads, and spreads the elements over processes.
/// @param points  Gauss points per element and direction; 0: what suits each space
/// @throws Error invalid_argument  supports or loads where there can be none
/// @throws Error conflict          supports that contradict each other
/// @cost   O(nodes), and the integration of the loads
CoupledProblem coupled_problem(const ElasticityProblem& problem, Coupling coupling, int points = 0,
                               const solvers::Processes& processes = {});

}  // namespace isopatch::iga
