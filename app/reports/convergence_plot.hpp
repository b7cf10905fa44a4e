#pragma once

#include <optional>

#include "app/plots/line_plot.hpp"
#include "app/results/run_summary.hpp"

namespace isopatch::app {

/// The error in the energy norm over the unknowns of a run's levels: as estimated, and by the extrapolated
/// energy where there is one. Nothing with fewer than two levels.
/// @param asked  the error that was asked for, relative: a level line
std::optional<LinePlot> convergence_plot(const std::vector<RunLevel>& levels,
                                         std::optional<double> asked = {});

}  // namespace isopatch::app
