#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/run/compare_non_matching.hpp"
#include "app/run/run_study.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"
#include "iga/output/interface_tractions.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// One coupling's share of a comparison.
struct CouplingRun {
  iga::Coupling coupling = iga::Coupling::elimination;
  iga::ProblemSize size;
  solvers::SolveReport solver;
  iga::ElasticityResults results;
  std::vector<iga::PhaseTime> timings;
  std::optional<double> condition = {};  ///< of the system, where it was asked for

  double seconds() const;  ///< of all phases
};

/// What one patch does to another across an interface.
struct InterfaceForce {
  std::string first;                     ///< face, as the input names it
  std::string second;                    ///< face
  double area = 0;                       ///< m^2
  std::optional<Eigen::Vector3d> force;  ///< of the second patch on the first, N
};

/// The same study solved with both couplings.
struct CouplingComparison {
  int refine = 0;                         ///< of the study's discretization
  std::array<int, 3> degree = {0, 0, 0};  ///< highest degree per direction over the patches
  CouplingRun elimination;
  CouplingRun lagrange;
  /// Largest difference of a displacement coefficient over the largest coefficient.
  double displacement_difference = 0;
  /// Difference of the internal energies over the larger one.
  double energy_difference = 0;
  /// Largest difference of a multiplier's force over the largest force, or over a thousandth of a node's
  /// share of what acts on the part if that is larger; 0 without multipliers.
  double multiplier_difference = 0;
  /// Of the difference of the two displacements, sampled as those in `ElasticityResults`: its length, m, and
  /// its von Mises stress, Pa. Parameters are in the input's naming.
  iga::Extremum largest_displacement_difference;
  iga::Extremum largest_stress_difference;
  std::vector<InterfaceForce> interfaces;
  std::optional<NonMatchingComparison> non_matching;  ///< where faces do not match; of elimination
  std::vector<Warning> warnings;

  static constexpr double allowed_difference = 1e-9;  ///< of displacement and energy
  static constexpr double allowed_multiplier_difference = 1e-8;
  bool agree() const;
  /// Whether patches meet at all, so that couplings can differ.
  bool has_coupling() const { return lagrange.size.multipliers > 0; }
};

/// A comparison with what pictures of it need.
struct ComparedStudy {
  CouplingComparison comparison;
  StudyRun run;  ///< with multipliers; without probes
  std::vector<iga::InterfaceTraction> tractions;
};

/// Solves a study with elimination and with multipliers. Of the methods that suit one of them only, cg and
/// minres take each other's place, and cholmod is used for elimination alone.
/// @param condition  whether to estimate the condition of systems that are factorized; on one process
ComparedStudy compare_couplings(const Study& study, bool condition, const Progress& progress = {});

}  // namespace isopatch::app
