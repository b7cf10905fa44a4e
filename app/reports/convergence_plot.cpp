#include "app/reports/convergence_plot.hpp"

#include <cmath>

#include "app/run/extrapolation.hpp"

namespace isopatch::app {

std::optional<LinePlot> convergence_plot(const std::vector<RunLevel>& levels, std::optional<double> asked) {
  if (levels.size() < 2) return std::nullopt;
  PlotSeries estimated{.name = "estimated", .x = {}, .y = {}};
  PlotSeries measured{.name = "from the extrapolated energy", .x = {}, .y = {}, .dashed = true};
  std::vector<double> energies;
  for (const RunLevel& level : levels) energies.push_back(level.internal_energy);
  const std::optional<Extrapolation> limit = is_even(levels) ? extrapolated(energies) : std::nullopt;
  for (const RunLevel& level : levels) {
    const auto unknowns = static_cast<double>(level.unknowns);
    if (level.error) {
      estimated.x.push_back(unknowns);
      estimated.y.push_back(*level.error);
    }
    if (limit) {
      measured.x.push_back(unknowns);
      measured.y.push_back(
          std::sqrt(std::abs(limit->limit - level.internal_energy) / std::abs(limit->limit)));
    }
  }
  LinePlot plot{.title = "Error of the discretization",
                .description = "Error in the energy norm over the number of unknowns, level by level",
                .x = {.label = "unknowns", .unit = "", .scale = Scale::logarithmic},
                .y = {.label = "error in the energy norm", .unit = "", .scale = Scale::logarithmic},
                .series = {}};
  for (PlotSeries* series : {&estimated, &measured})
    if (!series->x.empty()) plot.series.push_back(std::move(*series));
  if (plot.series.empty()) return std::nullopt;
  if (asked) plot.levels.push_back({"asked for", *asked});
  return plot;
}

}  // namespace isopatch::app
