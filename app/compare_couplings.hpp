#pragma once

#include <string>

#include "app/run_study.hpp"
#include "app/study.hpp"

namespace isopatch::app {

/// One coupling's share of a comparison.
struct CouplingRun {
  iga::Coupling coupling = iga::Coupling::elimination;
  iga::ProblemSize size;
  solvers::SolveReport solver;
  iga::ElasticityResults results;
  std::vector<iga::PhaseTime> timings;
};

/// The same study solved with both couplings.
struct CouplingComparison {
  CouplingRun elimination;
  CouplingRun lagrange;
  /// Largest difference of a displacement coefficient over the largest coefficient.
  double displacement_difference = 0;
  /// Difference of the internal energies over the larger one.
  double energy_difference = 0;
  /// Largest difference of a multiplier's force over the largest force; 0 without multipliers.
  double multiplier_difference = 0;
  std::vector<Warning> warnings;

  static constexpr double allowed_difference = 1e-9;  ///< of displacement and energy
  static constexpr double allowed_multiplier_difference = 1e-8;
  bool agree() const;
};

/// Solves a study with elimination and with multipliers. A solver method that only suits one of them
/// (cholmod, cg) is used for elimination alone.
CouplingComparison compare_couplings(const Study& study, const Progress& progress = {});

/// compare.json; SUMMARY.md documents its keys.
std::string comparison_json(const Study& study, const CouplingComparison& comparison);

/// The table for the terminal.
std::string comparison_text(const Study& study, const CouplingComparison& comparison);

}  // namespace isopatch::app
