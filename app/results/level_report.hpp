#pragma once

#include <string>

#include "app/results/run_summary.hpp"
#include "app/run/run_study.hpp"

namespace isopatch::app {

/// The table of a run's levels for the terminal, with the limit of the energy or that there is none, and
/// whether the largest stress has one; nothing for a run of one level.
std::string run_levels_text(const std::vector<RunLevel>& levels);

/// What an adaptive run was asked for and whether it is reached: "1 % in the energy norm asked: reached".
std::string accuracy_text(const AccuracyOutcome& accuracy);

}  // namespace isopatch::app
