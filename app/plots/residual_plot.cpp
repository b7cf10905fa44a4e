#include "app/plots/residual_plot.hpp"

#include <algorithm>

namespace isopatch::app {

std::optional<LinePlot> residual_plot(const std::vector<ResidualHistory>& histories, double tolerance) {
  constexpr std::size_t least = 4;  // the start and three iterations
  const auto is_long = [](const ResidualHistory& history) { return history.values.size() >= least; };
  if (std::none_of(histories.begin(), histories.end(), is_long)) return std::nullopt;
  const bool in_energy = std::all_of(histories.begin(), histories.end(),
                                     [](const ResidualHistory& history) { return history.in_energy; });
  LinePlot plot{.title = "Residual of each iteration",
                .description = "How the solver came to its tolerance, iteration by iteration",
                .x = {.label = "iteration", .unit = "", .whole_numbers = true},
                .y = {.label = in_energy ? "relative error, about in energy" : "relative residual",
                      .unit = "",
                      .scale = Scale::logarithmic},
                .series = {},
                .levels = {{"tolerance", tolerance}}};
  for (const ResidualHistory& history : histories) {
    PlotSeries series{.name = history.name, .x = {}, .y = history.values, .dashed = !plot.series.empty()};
    for (std::size_t i = 0; i < history.values.size(); ++i) series.x.push_back(static_cast<double>(i));
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace isopatch::app
