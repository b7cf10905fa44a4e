#include "app/results/level_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/base/engineering_units.hpp"
#include "app/results/internal/levels_json.hpp"
#include "app/run/extrapolation.hpp"

namespace isopatch::app {
namespace {

std::vector<double> values_of(const std::vector<RunLevel>& levels, double RunLevel::*what) {
  std::vector<double> result;
  for (const RunLevel& level : levels) result.push_back(level.*what);
  return result;
}

std::string verdict(const std::vector<RunLevel>& levels) {
  const auto before = [&](std::size_t i) { return levels[levels.size() - i].internal_energy; };
  if (!is_even(levels)) return "";
  if (levels.size() < 3) return "  limits of energy and stress can be told from three levels on\n";
  const auto energy = extrapolated(values_of(levels, &RunLevel::internal_energy));
  std::string text =
      energy ? fmt::format("  limit of the energy {} (extrapolated, {:+.2g} %, give or take {:.2g} %)\n",
                           with_unit(energy->limit, "J"),
                           100 * (energy->limit / levels.back().internal_energy - 1),
                           100 * energy->doubt / std::abs(energy->limit))
      : is_settled(before(1), before(2))
          ? "  the energy does not change any more\n"
          : "  no limit of the energy can be told: its changes do not shrink evenly\n";
  if (grows(values_of(levels, &RunLevel::max_von_mises)))
    text +=
        "  the largest von Mises stress grows with refinement: at a sharp corner or edge it has no limit\n";
  return text;
}

}  // namespace

std::string accuracy_text(const AccuracyOutcome& accuracy) {
  std::vector<std::string> goals;
  const AccuracyInput& asked = accuracy.asked;
  if (asked.energy) goals.push_back(fmt::format("{:.2g} % in the energy norm", 100 * *asked.energy));
  if (asked.stress)
    goals.push_back(fmt::format("{:.2g} % of the {}", 100 * *asked.stress,
                                asked.probe.empty() ? "largest stress" : "stress at " + asked.probe));
  return fmt::format(
      "{} asked: {}", fmt::join(goals, " and "),
      accuracy.missing.empty() ? "reached, as estimated" : "not reached, since " + accuracy.missing);
}

std::string run_levels_text(const std::vector<RunLevel>& levels) {
  if (levels.empty()) return "";
  std::string text =
      fmt::format("  {:>6} {:>12} {:>17} {:>14} {:>12} {:>21}  {}\n", is_even(levels) ? "refine" : "step",
                  "unknowns", "max displacement", "max von Mises", "energy", "error in energy norm", "time");
  for (const RunLevel& level : levels)
    text += fmt::format("  {:>6} {:>12} {:>17} {:>14} {:>12} {:>21}  {}\n", level.refine,
                        with_separators(level.unknowns), with_unit(level.max_displacement, "m"),
                        with_unit(level.max_von_mises, "Pa"), with_unit(level.internal_energy, "J"),
                        level.error ? fmt::format("{:.2g} %", 100 * *level.error) : "not estimated",
                        seconds_text(level.seconds));
  return text + verdict(levels);
}

Json levels_json(const std::vector<RunLevel>& levels) {
  Json result = Json::array();
  for (const RunLevel& level : levels)
    result.push_back({{"refine", level.refine},
                      {"dofs", level.unknowns},
                      {"internal_energy", level.internal_energy},
                      {"max_displacement", level.max_displacement},
                      {"max_von_mises", level.max_von_mises},
                      {"energy_norm_error", level.error ? Json(*level.error) : Json(nullptr)},
                      {"seconds", level.seconds}});
  return result;
}

Json accuracy_json(const AccuracyOutcome& accuracy) {
  const auto goal = [](const std::optional<double>& of) { return of ? Json(*of) : Json(nullptr); };
  return {{"energy", goal(accuracy.asked.energy)}, {"stress", goal(accuracy.asked.stress)},
          {"probe", accuracy.asked.probe},         {"reached", accuracy.missing.empty()},
          {"missing", accuracy.missing},           {"text", accuracy_text(accuracy)}};
}

Json convergence_json(const std::vector<RunLevel>& levels) {
  if (!is_even(levels))
    return {
        {"extrapolated_energy", nullptr}, {"extrapolation_doubt", nullptr}, {"max_von_mises_grows", false}};
  const auto energy = extrapolated(values_of(levels, &RunLevel::internal_energy));
  return {{"extrapolated_energy", energy ? Json(energy->limit) : Json(nullptr)},
          {"extrapolation_doubt", energy ? Json(energy->doubt) : Json(nullptr)},
          {"max_von_mises_grows", grows(values_of(levels, &RunLevel::max_von_mises))}};
}

}  // namespace isopatch::app
