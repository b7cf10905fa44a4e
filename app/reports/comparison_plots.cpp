#include "app/reports/comparison_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/plots/bar_plot.hpp"
#include "app/plots/residual_plot.hpp"
#include "app/reports/comparison_report.hpp"
#include "geometry/base/larger.hpp"

namespace isopatch::app {
namespace {

using Levels = std::vector<CouplingComparison>;
using Value = std::function<double(const CouplingRun&)>;

double phase_seconds(const CouplingRun& run, const std::string& phase) {
  double seconds = 0;
  for (const iga::PhaseTime& time : run.timings)
    if (time.phase == phase) seconds += time.seconds;
  return seconds;
}

std::vector<std::string> phases(const CouplingComparison& level) {
  std::vector<std::string> names;
  for (const CouplingRun* run : {&level.elimination, &level.lagrange})
    for (const iga::PhaseTime& time : run->timings)
      if (std::find(names.begin(), names.end(), time.phase) == names.end()) names.push_back(time.phase);
  return names;
}

BarPlot time_bars(const CouplingComparison& level) {
  BarPlot plot{.title = "Time per phase",
               .description = "Seconds of each phase, by elimination and with Lagrange multipliers",
               .label = "time",
               .unit = "s",
               .parts = phases(level),
               .bars = {{"elimination", {}}, {"Lagrange multipliers", {}}}};
  for (const std::string& phase : plot.parts) {
    plot.bars[0].values.push_back(phase_seconds(level.elimination, phase));
    plot.bars[1].values.push_back(phase_seconds(level.lagrange, phase));
  }
  return plot;
}

ResidualHistory history(const char* name, const CouplingRun& run) {
  return {fmt::format("{}: {}", name, solvers::name(run.solver.method)), run.solver.residual_history,
          run.solver.levels > 0};
}

/// Levels of one degree.
std::vector<Levels> by_degree(const Levels& levels) {
  std::vector<Levels> groups;
  for (const CouplingComparison& level : levels) {
    if (groups.empty() || groups.back().back().degree != level.degree) groups.emplace_back();
    groups.back().push_back(level);
  }
  return groups;
}

int highest_degree(const Levels& levels) {
  const auto& degree = levels.front().degree;
  return larger(degree[0], larger(degree[1], degree[2]));
}

/// A name of a series, with the degree if there are several.
std::string series_name(const std::string& name, const std::vector<Levels>& groups, const Levels& group) {
  return groups.size() == 1 ? name : fmt::format("{}, degree {}", name, highest_degree(group));
}

LinePlot over_unknowns(const std::string& title, const std::string& description, const PlotAxis& y) {
  return {.title = title,
          .description = description,
          .x = {.label = "unknowns", .unit = "", .scale = Scale::logarithmic},
          .y = y,
          .series = {}};
}

/// Matrices that are not stored have no entries, and phases that are not there take no time.
bool is_line(const PlotSeries& series) {
  return std::count_if(series.y.begin(), series.y.end(), [](double value) { return value > 0; }) > 1;
}

/// Adds a value of both couplings, that of elimination drawn through.
void add_runs(LinePlot& plot, const std::vector<Levels>& groups, const std::string& name,
              const Value& value) {
  const std::string what = name.empty() ? "" : ": " + name;
  for (const Levels& group : groups) {
    PlotSeries elimination{.name = series_name("elimination" + what, groups, group), .x = {}, .y = {}};
    PlotSeries lagrange{
        .name = series_name("multipliers" + what, groups, group), .x = {}, .y = {}, .dashed = true};
    for (const CouplingComparison& level : group) {
      elimination.x.push_back(static_cast<double>(level.elimination.size.dofs));
      elimination.y.push_back(value(level.elimination));
      lagrange.x.push_back(static_cast<double>(level.lagrange.size.dofs));
      lagrange.y.push_back(value(level.lagrange));
    }
    for (PlotSeries* series : {&elimination, &lagrange})
      if (is_line(*series)) plot.series.push_back(std::move(*series));
  }
}

LinePlot time_plot(const std::vector<Levels>& groups) {
  LinePlot plot = over_unknowns("Time over unknowns", "Seconds of both couplings at each level",
                                {.label = "time", .unit = "s", .scale = Scale::logarithmic});
  add_runs(plot, groups, "all", [](const CouplingRun& run) { return run.seconds(); });
  if (groups.size() > 1) return plot;  // of several degrees the phases would be too many lines
  for (const char* phase : {"assembly", "solve"})
    add_runs(plot, groups, phase, [phase](const CouplingRun& run) { return phase_seconds(run, phase); });
  return plot;
}

LinePlot memory_plot(const std::vector<Levels>& groups) {
  LinePlot plot = over_unknowns("Memory over unknowns", "Megabytes that the solvers held at their peak",
                                {.label = "memory of the solver", .unit = "MB", .scale = Scale::logarithmic});
  add_runs(plot, groups, "",
           [](const CouplingRun& run) { return static_cast<double>(run.solver.memory_bytes) / 1e6; });
  return plot;
}

LinePlot nonzeros_plot(const std::vector<Levels>& groups) {
  LinePlot plot = over_unknowns("Nonzeros over unknowns", "Entries of matrices and factors",
                                {.label = "nonzeros", .unit = "", .scale = Scale::logarithmic});
  add_runs(plot, groups, "matrix",
           [](const CouplingRun& run) { return static_cast<double>(run.solver.matrix_nonzeros); });
  add_runs(plot, groups, "factor",
           [](const CouplingRun& run) { return static_cast<double>(run.solver.factor_nonzeros); });
  return plot;
}

LinePlot condition_plot(const std::vector<Levels>& groups) {
  LinePlot plot = over_unknowns("Condition over unknowns", "Estimated condition numbers of both systems",
                                {.label = "condition number", .unit = "", .scale = Scale::logarithmic});
  add_runs(plot, groups, "", [](const CouplingRun& run) { return run.condition.value_or(0); });
  return plot;
}

LinePlot iterations_plot(const std::vector<Levels>& groups) {
  LinePlot plot = over_unknowns("Iterations over unknowns",
                                "Krylov iterations, or steps of refinement of a direct method",
                                {.label = "iterations", .unit = "", .whole_numbers = true, .include = {0}});
  add_runs(plot, groups, "",
           [](const CouplingRun& run) { return static_cast<double>(run.solver.iterations); });
  return plot;
}

LinePlot differences_plot(const std::vector<Levels>& groups) {
  LinePlot plot = over_unknowns("Differences of the two couplings over unknowns",
                                "Largest relative differences, and those that are allowed",
                                {.label = "relative difference", .unit = "", .scale = Scale::logarithmic});
  plot.levels = {{"allowed", CouplingComparison::allowed_difference},
                 {"allowed for multipliers", CouplingComparison::allowed_multiplier_difference}};
  const auto add = [&](const char* name, double CouplingComparison::*value) {
    for (const Levels& group : groups) {
      PlotSeries series{.name = series_name(name, groups, group), .x = {}, .y = {}};
      for (const CouplingComparison& level : group) {
        series.x.push_back(static_cast<double>(level.elimination.size.dofs));
        series.y.push_back(level.*value);
      }
      plot.series.push_back(std::move(series));
    }
  };
  add("displacement", &CouplingComparison::displacement_difference);
  add("energy", &CouplingComparison::energy_difference);
  add("multipliers", &CouplingComparison::multiplier_difference);
  return plot;
}

/// No series if no energies converge.
LinePlot energy_plot(const std::vector<Levels>& groups) {
  LinePlot plot =
      over_unknowns("Error in energy over unknowns",
                    "Relative difference of the internal energy from the limit of the last three levels; the "
                    "expected slope is that "
                    "of a smooth solution",
                    {.label = "relative error in energy", .unit = "", .scale = Scale::logarithmic});
  for (const Levels& group : groups) {
    const auto limit = extrapolated_energy(group);
    if (!limit) continue;
    PlotSeries series{.name = fmt::format("degree {}", highest_degree(group)),
                      .x = {},
                      .y = {},
                      .expected_slope = -2. / 3 * highest_degree(group)};
    for (const CouplingComparison& level : group) {
      series.x.push_back(static_cast<double>(level.elimination.size.dofs));
      series.y.push_back(std::abs(level.elimination.results.internal_energy / *limit - 1));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::vector<PagePlot> comparison_plots(const Levels& levels, double tolerance) {
  std::vector<PagePlot> plots;
  const auto add = [&](const auto& plot) { plots.push_back({"", to_svg(plot)}); };
  const CouplingComparison& finest = levels.back();
  add(time_bars(finest));
  if (const auto residuals = residual_plot(
          {history("elimination", finest.elimination), history("multipliers", finest.lagrange)}, tolerance))
    add(*residuals);
  if (levels.size() == 1) return plots;
  const std::vector<Levels> groups = by_degree(levels);
  for (const LinePlot& plot :
       {time_plot(groups), memory_plot(groups), nonzeros_plot(groups), iterations_plot(groups),
        condition_plot(groups), differences_plot(groups), energy_plot(groups)})
    if (!plot.series.empty()) add(plot);
  return plots;
}

}  // namespace isopatch::app
