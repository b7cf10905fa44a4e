#include "app/compare_couplings.hpp"

#include <fmt/format.h>

#include <map>

#include "app/engineering_units.hpp"
#include "app/internal/json_values.hpp"
#include "app/summary.hpp"

namespace isopatch::app {
namespace {

CouplingRun summarized(const iga::ElasticitySolution& solution, iga::Coupling coupling) {
  return {coupling, solution.size, solution.solver, solution.results, solution.timings};
}

double ratio(double difference, double scale) {
  return scale > 0 ? difference / scale : difference;
}

double displacement_difference(const iga::ElasticField& a, const iga::ElasticField& b) {
  double difference = 0;
  double scale = 0;
  for (std::size_t i = 0; i < a.displacement.size(); ++i) {
    difference = std::max(difference, (a.displacement[i] - b.displacement[i]).cwiseAbs().maxCoeff());
    scale = std::max(scale, a.displacement[i].cwiseAbs().maxCoeff());
  }
  return ratio(difference, scale);
}

double multiplier_difference(const std::vector<iga::Multiplier>& a, const std::vector<iga::Multiplier>& b) {
  std::map<std::pair<int, int>, Eigen::Vector3d> forces;
  for (const auto& multiplier : a) forces[{multiplier.first_node, multiplier.second_node}] = multiplier.force;
  double difference = 0;
  double scale = 0;
  for (const auto& multiplier : b) {
    const auto found = forces.find({multiplier.first_node, multiplier.second_node});
    const Eigen::Vector3d other = found == forces.end() ? Eigen::Vector3d::Zero() : found->second;
    difference = std::max(difference, (multiplier.force - other).cwiseAbs().maxCoeff());
    scale = std::max(scale, multiplier.force.cwiseAbs().maxCoeff());
  }
  return ratio(difference, scale);
}

Json run_json(const CouplingRun& run) {
  Json timings = Json::object();
  for (const auto& time : run.timings) timings[time.phase] = time.seconds;
  return {{"dofs", run.size.dofs},
          {"dofs_free", run.size.dofs_free},
          {"multipliers", run.coupling == iga::Coupling::lagrange ? run.size.multipliers : 0},
          {"method", solvers::name(run.solver.method)},
          {"iterations", run.solver.iterations},
          {"relative_residual", run.solver.relative_residual},
          {"matrix_nonzeros", run.solver.matrix_nonzeros},
          {"factor_nonzeros", run.solver.factor_nonzeros},
          {"memory_bytes", run.solver.memory_bytes},
          {"max_displacement", run.results.max_displacement.value},
          {"max_von_mises", run.results.max_von_mises.value},
          {"internal_energy", run.results.internal_energy},
          {"timings", timings}};
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

}  // namespace

bool CouplingComparison::agree() const {
  return displacement_difference <= allowed_difference && energy_difference <= allowed_difference &&
         multiplier_difference <= allowed_multiplier_difference;
}

CouplingComparison compare_couplings(const Study& study, const Progress& progress) {
  const BuiltProblem built = build_problem(study, progress);
  iga::ElasticityOptions options = study.options;
  options.coupling = iga::Coupling::elimination;
  const iga::ElasticitySolution eliminated = iga::solve_elasticity(built.problem, options, progress);
  options.coupling = iga::Coupling::lagrange;
  if (options.solver.method == solvers::Method::cholmod || options.solver.method == solvers::Method::cg)
    options.solver.method = solvers::Method::automatic;
  const iga::ElasticitySolution tied = iga::solve_elasticity(built.problem, options, progress);
  const double a = eliminated.results.internal_energy;
  const double b = tied.results.internal_energy;
  return {summarized(eliminated, iga::Coupling::elimination),
          summarized(tied, iga::Coupling::lagrange),
          displacement_difference(eliminated.field, tied.field),
          ratio(std::abs(a - b), std::max(std::abs(a), std::abs(b))),
          multiplier_difference(eliminated.multipliers, tied.multipliers),
          built.warnings};
}

std::string comparison_json(const Study& study, const CouplingComparison& comparison) {
  const Json json = {{"schema_version", 1},
                     {"program", {{"name", "isopatch"}, {"version", version()}}},
                     {"title", study.title},
                     {"study", study.source},
                     {"elimination", run_json(comparison.elimination)},
                     {"lagrange", run_json(comparison.lagrange)},
                     {"difference",
                      {{"displacement", comparison.displacement_difference},
                       {"internal_energy", comparison.energy_difference},
                       {"multipliers", comparison.multiplier_difference},
                       {"allowed", CouplingComparison::allowed_difference},
                       {"allowed_multipliers", CouplingComparison::allowed_multiplier_difference}}},
                     {"agree", comparison.agree()},
                     {"warnings", texts_json(comparison.warnings)},
                     {"warning_places", places_json(comparison.warnings)},
                     {"memory", {{"peak_bytes", peak_memory_bytes()}}}};
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
  text += row("matrix nonzeros", count(a.solver.matrix_nonzeros), count(b.solver.matrix_nonzeros));
  text += row("factor nonzeros", count(a.solver.factor_nonzeros), count(b.solver.factor_nonzeros));
  text += row("solver memory", bytes_text(a.solver.memory_bytes), bytes_text(b.solver.memory_bytes));
  text += row("relative residual", small(a.solver.relative_residual), small(b.solver.relative_residual));
  text += phase_rows(a, b);
  text += row("max displacement", with_unit(a.results.max_displacement.value, "m"),
              with_unit(b.results.max_displacement.value, "m"));
  text += row("max von Mises", with_unit(a.results.max_von_mises.value, "Pa"),
              with_unit(b.results.max_von_mises.value, "Pa"));
  text += row("internal energy", with_unit(a.results.internal_energy, "J"),
              with_unit(b.results.internal_energy, "J"));
  text += fmt::format(
      "  largest relative difference: displacement {:.2g}, energy {:.2g} (allowed {:.0e}), multipliers "
      "{:.2g} "
      "(allowed {:.0e})\n",
      comparison.displacement_difference, comparison.energy_difference,
      CouplingComparison::allowed_difference, comparison.multiplier_difference,
      CouplingComparison::allowed_multiplier_difference);
  return text + (comparison.agree() ? "  the two couplings agree\n" : "  THE TWO COUPLINGS DISAGREE\n");
}

}  // namespace isopatch::app
