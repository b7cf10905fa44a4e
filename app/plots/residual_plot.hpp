#pragma once

#include <optional>

#include "app/plots/line_plot.hpp"

namespace isopatch::app {

/// Relative residuals of one solver, the start first.
struct ResidualHistory {
  std::string name;  ///< "elimination: cg"
  std::vector<double> values;
  bool in_energy =
      false;  ///< whether they are about relative errors in energy, as a multigrid's norm gives them
};

/// Residuals over iterations, with the tolerance as a level.
/// @return  nothing if no history has three iterations: the one or two refinements of a direct method make no
///          picture
std::optional<LinePlot> residual_plot(const std::vector<ResidualHistory>& histories, double tolerance);

}  // namespace isopatch::app
