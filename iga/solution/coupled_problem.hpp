#pragma once

#include <vector>

#include "iga/assembly/mortar_constraints.hpp"
#include "iga/assembly/surface_stiffness.hpp"
#include "iga/coupling/coupling_kind.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/coupling/supported_system.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/problem/load_case.hpp"
#include "iga/problem/problem.hpp"
#include "iga/solution/right_side.hpp"
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
  std::vector<SupportFrame> frames;  ///< one per global node; what they prescribe is in the right sides
  std::vector<MultiplierRow> multipliers;
  MortarConstraints mortar;            ///< of faces that do not match; none with Nitsche's method
  std::vector<RightSide> right_sides;  ///< one per load case, at least one
  std::vector<PatchSpace> spaces;
  Distribution distribution;
  std::vector<PatchLayers> parts;  ///< what this process integrates

  /// What adds to the stiffness: springs and, unless multipliers hold faces that do not match, Nitsche's
  /// terms.
  SurfaceTerms surfaces() const;

  const Discretization& discretization() const { return problem->discretization; }
  const SupportFrame& frame_of(int node) const {
    return frames[static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(node)])];
  }
};

/// How the patches of a problem are tied and integrated.
struct CouplingOptions {
  Coupling coupling = Coupling::elimination;
  int points = 0;  ///< Gauss points per element and direction; 0: what suits each space
  solvers::Processes processes = {};
  NonMatchingCoupling non_matching = NonMatchingCoupling::nitsche;
  MortarSide mortar_side = MortarSide::automatic;
};

/// Numbers the nodes globally, discretizes supports and loads, and spreads the elements over processes.
/// @throws Error invalid_argument  supports or loads where there can be none
/// @throws Error conflict          supports that contradict each other
/// @throws Error unsupported       interfaces that do not match, with what cannot treat them yet
/// @cost   O(nodes), and the integration of the loads and of multipliers between faces that do not match
CoupledProblem coupled_problem(const ElasticityProblem& problem, const CouplingOptions& options);

/// The same with a right side for each of some cases in place of the problem's own.
/// @throws Error invalid_argument  as `of_case` does
CoupledProblem coupled_cases(const ElasticityProblem& problem, const std::vector<LoadCase>& cases,
                             const CouplingOptions& options);

}  // namespace isopatch::iga
