#pragma once

#include <string>
#include <vector>

#include "app/pages/page.hpp"
#include "app/run/compare_couplings.hpp"

namespace isopatch::app {

/// Time per phase and residuals of the finest level; of several levels also time, memory, nonzeros,
/// iterations, differences and error in energy over the unknowns.
/// The plots have their titles inside.
/// @param levels     at least one, the finest last
/// @param tolerance  of the solvers
std::vector<PagePlot> comparison_plots(const std::vector<CouplingComparison>& levels, double tolerance);

}  // namespace isopatch::app
