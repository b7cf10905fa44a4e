#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace isopatch::app {

/// What one refinement comes to in a load case.
struct CaseLevel {
  double internal_energy = 0;        ///< J
  double max_displacement = 0;       ///< m
  double max_von_mises = 0;          ///< Pa
  std::optional<double> error = {};  ///< estimated, in the energy norm, relative
};

/// A run's figures on one of several refinements.
struct RunLevel {
  /// Of the study's discretization; of an adaptive run how often elements have been halved where it was
  /// needed.
  int refine = 0;
  std::int64_t unknowns = 0;         ///< before supports are fixed, multipliers included
  double internal_energy = 0;        ///< J
  double max_displacement = 0;       ///< m
  double max_von_mises = 0;          ///< Pa
  std::optional<double> error = {};  ///< estimated, in the energy norm, relative
  double seconds = 0;                ///< of all phases
  bool is_adaptive = false;          ///< whether some elements alone were halved since the level before
  /// Of a study with load cases the figures above are those of the first; these are those of all, in order.
  std::vector<CaseLevel> cases = {};
};

/// Levels with the figures of one of their cases; as they are where they have none.
std::vector<RunLevel> levels_of_case(std::vector<RunLevel> levels, std::size_t index);

/// Whether each level halves all elements of the one before, so that its figures have a limit that can be
/// told.
bool is_even(const std::vector<RunLevel>& levels);

}  // namespace isopatch::app
