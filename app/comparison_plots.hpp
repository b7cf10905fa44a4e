#pragma once

#include <string>
#include <vector>

#include "app/compare_couplings.hpp"

namespace isopatch::app {

/// A picture of a page.
struct NamedPlot {
  std::string title;
  std::string svg;
};

/// Time per phase and residuals of the finest level; of several levels also time, memory, nonzeros,
/// iterations, differences and error in energy over the unknowns.
/// @param levels     at least one, the finest last
/// @param tolerance  of the solvers
std::vector<NamedPlot> comparison_plots(const std::vector<CouplingComparison>& levels, double tolerance);

}  // namespace isopatch::app
