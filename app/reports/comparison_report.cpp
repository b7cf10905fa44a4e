#include "app/reports/comparison_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"
#include "app/run/extrapolation.hpp"

namespace isopatch::app {
namespace {

Json run_json(const CouplingRun& run) {
  Json timings = Json::object();
  for (const auto& time : run.timings) timings[time.phase] = time.seconds;
  timings["total"] = run.seconds();
  return {{"dofs", run.size.dofs},
          {"dofs_free", run.size.dofs_free},
          {"multipliers", run.coupling == iga::Coupling::lagrange ? run.size.multipliers : 0},
          {"method", solvers::name(run.solver.method)},
          {"reason", run.solver.reason},
          {"operator", solvers::name(run.solver.form)},
          {"levels", run.solver.levels},
          {"iterations", run.solver.iterations},
          {"relative_residual", run.solver.relative_residual},
          {"energy_error", run.solver.energy_error},
          {"residual_history", run.solver.residual_history},
          {"matrix_nonzeros", run.solver.matrix_nonzeros},
          {"factor_nonzeros", run.solver.factor_nonzeros},
          {"factor_flops", run.solver.factor_flops},
          {"memory_bytes", run.solver.memory_bytes},
          {"condition", run.condition ? Json(*run.condition) : Json(nullptr)},
          {"max_displacement", run.results.max_displacement.value},
          {"max_von_mises", run.results.max_von_mises.value},
          {"internal_energy", run.results.internal_energy},
          {"timings", timings}};
}

Json place_json(const iga::Extremum& extremum) {
  return {{"patch", extremum.patch}, {"parameter", to_json(Eigen::Vector3d(extremum.parameter))}};
}

Json difference_json(const CouplingComparison& comparison) {
  const iga::Extremum& displacement = comparison.largest_displacement_difference;
  const iga::Extremum& stress = comparison.largest_stress_difference;
  return {{"displacement", comparison.displacement_difference},
          {"internal_energy", comparison.energy_difference},
          {"multipliers", comparison.multiplier_difference},
          {"allowed", CouplingComparison::allowed_difference},
          {"allowed_multipliers", CouplingComparison::allowed_multiplier_difference},
          {"max_displacement", displacement.value},
          {"max_displacement_point", to_json(displacement.place)},
          {"max_displacement_at", place_json(displacement)},
          {"max_von_mises", stress.value},
          {"max_von_mises_point", to_json(stress.place)},
          {"max_von_mises_at", place_json(stress)}};
}

Json interfaces_json(const std::vector<InterfaceForce>& interfaces) {
  Json result = Json::array();
  for (const InterfaceForce& interface : interfaces)
    result.push_back({{"first", interface.first},
                      {"second", interface.second},
                      {"area", interface.area},
                      {"force", interface.force ? to_json(*interface.force) : Json(nullptr)}});
  return result;
}

Json non_matching_json(const std::optional<NonMatchingComparison>& compared) {
  if (!compared) return nullptr;
  const bool has_failed = !compared->failure.empty();
  return {{"own", iga::name(compared->own)},
          {"other", iga::name(compared->other)},
          {"failure", has_failed ? Json(compared->failure) : Json(nullptr)},
          {"energy", compared->energy},
          {"other_energy", has_failed ? Json(nullptr) : Json(compared->other_energy)},
          {"energy_difference", has_failed ? Json(nullptr) : Json(compared->energy_difference())},
          {"displacement_difference", has_failed ? Json(nullptr) : Json(compared->displacement_difference)},
          {"estimated_error", has_failed ? Json(nullptr) : Json(compared->estimated_error)},
          {"allowed_difference", has_failed ? Json(nullptr) : Json(compared->allowed_difference())},
          {"agree", compared->agree()}};
}

Json level_json(const CouplingComparison& level) {
  return {{"refine", level.refine},
          {"degree", level.degree},
          {"elements", level.elimination.size.elements},
          {"elimination", run_json(level.elimination)},
          {"lagrange", run_json(level.lagrange)},
          {"difference", difference_json(level)},
          {"coupled", level.has_coupling()},
          {"non_matching", non_matching_json(level.non_matching)},
          {"agree", level.agree()}};
}

/// A line of the table: what, and one cell for each coupling.
std::string row(const std::string& what, const std::string& a, const std::string& b) {
  return fmt::format("  {:<22} {:>16} {:>16}\n", what, a, b);
}

std::string phase_rows(const CouplingRun& a, const CouplingRun& b) {
  std::string text;
  for (const auto& time : a.timings) {
    std::string other = "-";
    for (const auto& candidate : b.timings)
      if (candidate.phase == time.phase) other = seconds_text(candidate.seconds);
    text += row("time: " + time.phase, seconds_text(time.seconds), other);
  }
  return text;
}

/// "3.1e-14 in displacement at (1, 2, 3) mm of patch 0".
std::string largest_text(const iga::Extremum& extremum, const char* unit, const char* what) {
  if (extremum.patch < 0) return "";
  return fmt::format("  largest difference in {}: {} at {} in patch {}\n", what,
                     fmt::format("{:.2g} {}", extremum.value, unit),
                     place_with_unit(extremum.place, extremum.place.norm()), extremum.patch);
}

// The two ways to couple faces that do not match.
std::string non_matching_text(const NonMatchingComparison& compared) {
  if (!compared.failure.empty())
    return fmt::format("  faces that do not match: not compared with {}: {}\n", iga::name(compared.other),
                       compared.failure);
  return fmt::format(
      "  faces that do not match by {} and by {}: energy with that between faces {} and {}, relative "
      "difference {:.2g}\n"
      "  ({} twice the estimated error of the discretization, {:.2g} of the energy), in displacement "
      "{:.2g}\n",
      iga::name(compared.own), iga::name(compared.other), with_unit(compared.energy, "J"),
      with_unit(compared.other_energy, "J"), compared.energy_difference(),
      compared.agree() ? "within" : "MORE THAN", compared.allowed_difference(),
      compared.displacement_difference);
}

std::string degree_text(const std::array<int, 3>& degree) {
  if (degree[0] == degree[1] && degree[1] == degree[2]) return std::to_string(degree[0]);
  return fmt::format("{},{},{}", degree[0], degree[1], degree[2]);
}

// What factorizations count are steps of refinement.
std::string iterations_text(const solvers::SolveReport& report) {
  return report.factor_nonzeros > 0 ? "none" : with_separators(report.iterations);
}

std::string level_row(const std::string& refine, const std::string& degree, const CouplingRun& run,
                      const std::string& difference) {
  return fmt::format("  {:>6} {:>6}  {:<11} {:>12} {:>8} {:>10} {:>10} {:>11}  {}\n", refine, degree,
                     iga::name(run.coupling), with_separators(run.size.dofs),
                     solvers::name(run.solver.method), iterations_text(run.solver),
                     bytes_text(run.solver.memory_bytes), seconds_text(run.seconds()), difference);
}

}  // namespace

std::string comparison_json(const Study& study, const std::vector<CouplingComparison>& levels) {
  const CouplingComparison& finest = levels.back();
  Json level_list = Json::array();
  for (const CouplingComparison& level : levels) level_list.push_back(level_json(level));
  const auto energy = extrapolated_energy(levels);
  Json json = {{"schema_version", 1},
               {"program", {{"name", "isopatch"}, {"version", version()}}},
               {"title", study.title},
               {"study", study.source}};
  json.update(level_json(finest));
  json["interfaces"] = interfaces_json(finest.interfaces);
  json["levels"] = level_list;
  json["extrapolated_energy"] = energy ? Json(*energy) : Json(nullptr);
  json["warnings"] = texts_json(finest.warnings);
  json["warning_places"] = places_json(finest.warnings);
  json["memory"] = {{"peak_bytes", peak_memory_bytes()}};
  return file_text(json);
}

std::string comparison_text(const Study& study, const CouplingComparison& comparison) {
  const CouplingRun& a = comparison.elimination;
  const CouplingRun& b = comparison.lagrange;
  const auto count = [](std::int64_t n) { return with_separators(n); };
  const auto small = [](double x) { return fmt::format("{:.2g}", x); };
  std::string text = study.title.empty() ? "" : study.title + "\n";
  text += row("", "elimination", "lagrange");
  text += row("unknowns", count(a.size.dofs), count(b.size.dofs));
  text += row("  free of supports", count(a.size.dofs_free), count(b.size.dofs_free));
  text += row("  multipliers", "0", count(b.size.multipliers));
  text +=
      row("solver", std::string(solvers::name(a.solver.method)), std::string(solvers::name(b.solver.method)));
  text += row("iterations", iterations_text(a.solver), iterations_text(b.solver));
  text += row("matrix nonzeros", count(a.solver.matrix_nonzeros), count(b.solver.matrix_nonzeros));
  text += row("factor nonzeros", count(a.solver.factor_nonzeros), count(b.solver.factor_nonzeros));
  text += row("solver memory", bytes_text(a.solver.memory_bytes), bytes_text(b.solver.memory_bytes));
  text += row("relative residual", small(a.solver.relative_residual), small(b.solver.relative_residual));
  if (a.condition && b.condition) text += row("condition", small(*a.condition), small(*b.condition));
  text += phase_rows(a, b);
  text += row("max displacement", with_unit(a.results.max_displacement.value, "m"),
              with_unit(b.results.max_displacement.value, "m"));
  text += row("max von Mises", with_unit(a.results.max_von_mises.value, "Pa"),
              with_unit(b.results.max_von_mises.value, "Pa"));
  text += row("internal energy", with_unit(a.results.internal_energy, "J"),
              with_unit(b.results.internal_energy, "J"));
  text += largest_text(comparison.largest_displacement_difference, "m", "displacement");
  text += largest_text(comparison.largest_stress_difference, "Pa", "stress (von Mises)");
  text += fmt::format(
      "  relative differences: displacement {:.2g}, energy {:.2g} (allowed {:.0e}), multipliers {:.2g} "
      "(allowed {:.0e})\n",
      comparison.displacement_difference, comparison.energy_difference,
      CouplingComparison::allowed_difference, comparison.multiplier_difference,
      CouplingComparison::allowed_multiplier_difference);
  if (comparison.non_matching) text += non_matching_text(*comparison.non_matching);
  if (!comparison.has_coupling())
    return text + (comparison.non_matching ? "  no two faces match, so both couplings are the same\n"
                                           : "  there is nothing to couple: no two patches meet\n");
  return text + (comparison.agree() ? "  the two couplings agree\n" : "  THE TWO COUPLINGS DISAGREE\n");
}

std::string levels_text(const std::vector<CouplingComparison>& levels) {
  std::string text = fmt::format("  {:>6} {:>6}  {:<11} {:>12} {:>8} {:>10} {:>10} {:>11}  {}\n", "refine",
                                 "degree", "coupling", "unknowns", "solver", "iterations", "memory", "time",
                                 "difference in displacement, energy, multipliers");
  for (const CouplingComparison& level : levels) {
    const std::string difference =
        fmt::format("{:.1e}  {:.1e}  {:.1e}{}", level.displacement_difference, level.energy_difference,
                    level.multiplier_difference, level.agree() ? "" : "  DISAGREE");
    text += level_row(std::to_string(level.refine), degree_text(level.degree), level.elimination, "");
    text += level_row("", "", level.lagrange, difference);
  }
  return text;
}

std::string disagreement_text(const CouplingComparison& comparison) {
  return fmt::format(
      "the two couplings disagree at refine = {}, degree {}: relative difference {:.2g} in displacement, "
      "{:.2g} in energy (allowed {:.0e}), {:.2g} in multipliers (allowed {:.0e}); look at the solver's "
      "residuals and at the model's gaps",
      comparison.refine, degree_text(comparison.degree), comparison.displacement_difference,
      comparison.energy_difference, CouplingComparison::allowed_difference, comparison.multiplier_difference,
      CouplingComparison::allowed_multiplier_difference);
}

std::optional<double> extrapolated_energy(const std::vector<CouplingComparison>& levels) {
  const std::size_t n = levels.size();
  if (n < 3 || levels[n - 3].degree != levels[n - 1].degree) return std::nullopt;
  std::vector<double> energies;
  for (const CouplingComparison& level : levels)
    energies.push_back(level.elimination.results.internal_energy);
  const std::optional<Extrapolation> found = extrapolated(energies);
  return found ? std::optional(found->limit) : std::nullopt;
}

}  // namespace isopatch::app
