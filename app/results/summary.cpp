#include "app/results/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/base/engineering_units.hpp"
#include "app/base/provenance.hpp"
#include "app/problem/resolution_warning.hpp"
#include "app/problem/selection.hpp"
#include "app/results/internal/json_regions.hpp"
#include "app/results/internal/levels_json.hpp"
#include "app/results/internal/parameterization_json.hpp"
#include "app/results/level_report.hpp"
#include "iga/material/material.hpp"
#include "iga/post/stress_measures.hpp"

namespace isopatch::app {
namespace {

Json model_json(const StudyRun& run) {
  const auto& model = run.built.problem.discretization.model;
  const ModelReport& report = run.built.report;
  double worst = 1;
  for (const PatchReport& patch : report.patches) worst = std::min(worst, patch.quality.min_scaled_jacobian);
  Json reversed = Json::array();
  Json refused = Json::array();
  for (std::size_t i = 0; i < report.patches.size(); ++i) {
    if (report.patches[i].was_left_handed) reversed.push_back(i);
    if (!report.patches[i].certificate.accepted()) refused.push_back(i);
  }
  return {{"patches", model.patch_count()},
          {"interfaces", model.interfaces().size()},
          {"boundary_faces", model.boundary_faces().size()},
          {"bodies", report.bodies.size()},
          {"control_points", report.control_points},
          {"elements", report.elements},
          {"volume", report.volume},
          {"boundary_area", report.boundary_area},
          {"box",
           {{"min", to_json(Eigen::Vector3d(report.box.min()))},
            {"max", to_json(Eigen::Vector3d(report.box.max()))}}},
          {"largest_gap", report.largest_gap},
          {"min_scaled_jacobian", worst},
          {"left_handed_patches", reversed},
          {"patches_not_certified", refused}};
}

Json discretization_json(const StudyRun& run, int asked_points) {
  const iga::ProblemSize& size = run.solution.size;
  std::array<int, 3> degree{};
  for (const auto& patch : run.built.problem.discretization.patches)
    for (int d = 0; d < 3; ++d) {
      auto& highest = degree[static_cast<std::size_t>(d)];
      highest = std::max(highest, patch.degree(d));
    }
  std::array<int, 3> points{};
  for (int p = 0; p < run.built.problem.discretization.patch_count(); ++p) {
    const iga::GaussPoints of_patch = run.built.problem.discretization.points_of(p, asked_points);
    for (std::size_t d = 0; d < 3; ++d) points[d] = std::max(points[d], of_patch[d]);
  }
  return {{"degree", degree},
          {"gauss_points", points},
          {"elements", size.elements},
          {"control_points", size.control_points},
          {"dofs_uncoupled", size.dofs_uncoupled},
          {"dofs_eliminated", size.dofs_eliminated},
          {"multipliers", size.multipliers},
          {"multipliers_free", size.multipliers_free},
          {"dofs", size.dofs},
          {"dofs_free", size.dofs_free}};
}

Json materials_json(const Study& study, const StudyRun& run) {
  Json result = Json::array();
  for (const MaterialInput& input : study.materials) {
    Json patches = Json::array();
    for (const PatchId id : select_patches(run.built.problem.discretization.model, input.patches))
      patches.push_back(id.value);
    result.push_back({{"name", input.material.name},
                      {"patches", patches},
                      {"lambda", input.material.lambda},
                      {"mu", input.material.mu},
                      {"young", iga::young(input.material)},
                      {"poisson", iga::poisson(input.material)},
                      {"density", input.material.density},
                      {"yield", input.material.yield > 0 ? Json(input.material.yield) : Json()}});
  }
  return result;
}

Json caught_json(const std::vector<AppliedRegion>& regions) {
  Json result = Json::array();
  for (const AppliedRegion& region : regions)
    result.push_back({{"name", region.key},
                      {"kind", region.kind},
                      {"given", region.given},
                      {"faces", region.faces},
                      {"area", region.area}});
  return result;
}

}  // namespace

Json supports_json(const std::vector<AppliedRegion>& supports) {
  Json result = caught_json(supports);
  for (std::size_t i = 0; i < supports.size(); ++i) result[i]["edges"] = supports[i].edges;
  return result;
}

Json loads_json(const std::vector<AppliedRegion>& loads) {
  Json result = caught_json(loads);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    result[i]["patches"] = loads[i].patches;
    result[i]["volume"] = loads[i].volume;
    result[i]["total"] = to_json(loads[i].total);
  }
  return result;
}

namespace {

Json solver_json(const solvers::SolveReport& report, double tolerance, std::int64_t predicted_bytes) {
  return {{"method", solvers::name(report.method)},
          {"reason", report.reason},
          {"iterations", report.iterations},
          {"tolerance", tolerance},
          {"relative_residual", report.relative_residual},
          {"energy_error", report.energy_error},
          {"residual_history", report.residual_history},
          {"operator", solvers::name(report.form)},
          {"levels", report.levels},
          {"matrix_nonzeros", report.matrix_nonzeros},
          {"factor_nonzeros", report.factor_nonzeros},
          {"factor_flops", report.factor_flops},
          {"memory_bytes", report.memory_bytes},
          {"predicted_bytes", predicted_bytes},
          {"analysis_seconds", report.analysis_seconds},
          {"factorization_seconds", report.factorization_seconds},
          {"solve_seconds", report.solve_seconds}};
}

// Moved from the origin.
Eigen::Vector3d moment_about(const Eigen::Vector3d& point, const iga::Reaction& reaction) {
  return reaction.moment - point.cross(reaction.force);
}

Json reactions_json(const StudyRun& run, const iga::ElasticityResults& results,
                    const Eigen::Vector3d& point) {
  Json reactions = Json::array();
  for (std::size_t i = 0; i < run.built.supports.size(); ++i) {
    const iga::Reaction& reaction = results.reactions[i];
    reactions.push_back({{"support", run.built.supports[i].key},
                         {"force", to_json(reaction.force)},
                         {"moment", to_json(reaction.moment)},
                         {"moment_about_point", to_json(moment_about(point, reaction))}});
  }
  return reactions;
}

Json error_json(const StudyRun& run) {
  if (!run.error) return run.error_missing.empty() ? Json(nullptr) : Json{{"missing", run.error_missing}};
  return {{"energy_norm", run.error->relative},
          {"energy", run.error->energy},
          {"max_von_mises", iga::von_mises(run.error->stress_at_max)},
          {"singular", run.error->singular ? Json(*run.error->singular) : Json(nullptr)},
          {"iterations", run.error->iterations}};
}

Json results_json(const Study& study, const StudyRun& run, const iga::ElasticityResults& results) {
  const auto& model = run.built.problem.discretization.model;
  const auto at = [&](const iga::Extremum& e) {
    if (e.patch < 0) return Json(nullptr);
    return Json{{"patch", e.patch},
                {"parameter", to_json(Eigen::Vector3d(model.to_input(PatchId(e.patch), e.parameter)))}};
  };
  const iga::StressPeaks& peaks = results.peaks;
  const bool has_yield = peaks.utilization.patch >= 0;
  return {{"max_displacement", results.max_displacement.value},
          {"max_displacement_point", to_json(results.max_displacement.place)},
          {"max_displacement_at", at(results.max_displacement)},
          {"internal_energy", results.internal_energy},
          {"support_energy", results.support_energy},
          {"external_work", results.external_work},
          {"thermal_work", results.thermal_work},
          {"max_von_mises", results.max_von_mises.value},
          {"max_von_mises_point", to_json(results.max_von_mises.place)},
          {"max_von_mises_at", at(results.max_von_mises)},
          {"max_von_mises_sampled", "at Gauss points and on faces"},
          {"max_principal", peaks.tension.value},
          {"max_principal_point", to_json(peaks.tension.place)},
          {"max_principal_at", at(peaks.tension)},
          {"min_principal", -peaks.compression.value},
          {"min_principal_point", to_json(peaks.compression.place)},
          {"min_principal_at", at(peaks.compression)},
          {"max_tresca", peaks.tresca.value},
          {"max_tresca_point", to_json(peaks.tresca.place)},
          {"max_tresca_at", at(peaks.tresca)},
          {"min_safety_factor", has_yield ? Json(1 / peaks.utilization.value) : Json()},
          {"min_safety_factor_point", has_yield ? to_json(peaks.utilization.place) : Json()},
          {"min_safety_factor_at", at(peaks.utilization)},
          {"points_left_out",
           {{"folded", results.left_out.folded},
            {"collapsed", results.left_out.collapsed},
            {"worst_at", at(results.left_out.worst)}}},
          {"max_strain", results.max_strain.value},
          {"max_strain_at", at(results.max_strain)},
          {"unresolved_energy_share", unresolved_share(results)},
          {"discretization_error", &results == &run.solution.results ? error_json(run) : Json(nullptr)},
          {"total_load", to_json(results.total_load)},
          {"moments_about", to_json(study.output.moments_about)},
          {"reactions", reactions_json(run, results, study.output.moments_about)}};
}

Json probes_json(const std::vector<ProbeValues>& probes) {
  Json result = Json::array();
  for (const ProbeValues& probe : probes) {
    result.push_back({{"name", probe.name},
                      {"patch", probe.patch},
                      {"parameter", to_json(Eigen::Vector3d(probe.parameter))},
                      {"point", to_json(probe.values.place)},
                      {"displacement", to_json(probe.values.displacement)},
                      {"stress", symmetric_to_json(probe.values.stress)},
                      {"von_mises", probe.values.von_mises},
                      {"principal", to_json(iga::principal_values(probe.values.stress))},
                      {"tresca", iga::tresca(probe.values.stress)}});
    for (const ProbeSide& side : probe.sides)
      result.back()["sides"].push_back({{"patch", side.patch},
                                        {"parameter", to_json(Eigen::Vector3d(side.parameter))},
                                        {"material", side.material},
                                        {"stress", symmetric_to_json(side.values.stress)},
                                        {"von_mises", side.values.von_mises}});
    if (probe.stress_error) result.back()["von_mises_error"] = iga::von_mises(*probe.stress_error);
  }
  return result;
}

Json sections_json(const std::vector<SectionValues>& sections) {
  Json result = Json::array();
  for (const SectionValues& section : sections)
    result.push_back({{"name", section.name},
                      {"point", to_json(section.plane.point)},
                      {"normal", to_json(section.plane.normal)},
                      {"area", section.forces.area},
                      {"centre", to_json(section.forces.centre)},
                      {"force", to_json(section.forces.force)},
                      {"moment", to_json(section.forces.moment)}});
  return result;
}

Json mass_json(const std::optional<MassProperties>& mass) {
  if (!mass) return nullptr;
  return {
      {"mass", mass->mass}, {"centre", to_json(mass->centre)}, {"inertia", symmetric_to_json(mass->inertia)}};
}

Json cases_json(const Study& study, const StudyRun& run) {
  Json result = Json::array();
  if (!run.has_cases()) return result;
  for (const CaseView& one : cases_of(run)) {
    Json factors = Json::object();
    for (const auto& [name, factor] : one.name.factors) factors[name] = factor;
    result.push_back({{"name", one.name.name},
                      {"kind", one.name.factors.empty() ? "case" : "combination"},
                      {"loads", one.name.loads},
                      {"factors", factors},
                      {"results", results_json(study, run, one.solution.results)},
                      {"probes", probes_json(one.probes)},
                      {"sections", sections_json(one.sections)},
                      {"solver", solver_json(one.solution.solver, study.options.solver.tolerance,
                                             one.solution.predicted_bytes)}});
  }
  return result;
}

Json timings_json(const StudyRun& run) {
  Json result = Json::object();
  double total = 0;
  for (const iga::PhaseTime& time : run.timings) {
    result[time.phase] = time.seconds;
    total += time.seconds;
  }
  result["total"] = total;
  return result;
}

std::string regions_text(const StudyRun& run) {
  std::string text;
  for (const AppliedRegion& region : run.built.supports)
    text += fmt::format("  support           {}\n", region_text(region));
  for (const AppliedRegion& region : run.built.loads)
    text += fmt::format("  load              {}\n", region_text(region));
  return text;
}

std::string reactions_text(const StudyRun& run, const iga::ElasticityResults& results) {
  // Reactions that balance inside one support vanish beside the stresses on the surface.
  double scale =
      std::max(results.total_load.norm(), results.max_von_mises.value * run.built.report.boundary_area);
  for (const iga::Reaction& reaction : results.reactions) scale = std::max(scale, reaction.force.norm());
  std::string text;
  for (const iga::Reaction& reaction : results.reactions)
    text += fmt::format("  reaction          {} at {}\n",
                        vector_with_unit(without_round_off(reaction.force, scale), "N"), reaction.support);
  return text;
}

// "12.34 MPa +- 0.5": the uncertainty in the unit of the value.
std::string with_uncertainty(double value, const std::optional<Eigen::Matrix3d>& stress_error, double scale) {
  const std::string text = with_unit(without_round_off(value, scale), "Pa");
  if (!stress_error) return text;
  const double error = without_round_off(iga::von_mises(*stress_error), scale);
  return fmt::format("{} +- {:.2g}", text, error / unit_for(value, "Pa").factor);
}

std::string error_text(const StudyRun& run) {
  if (!run.error)
    return run.error_missing.empty()
               ? ""
               : fmt::format("  discretization    its error is not estimated: {}\n", run.error_missing);
  // The norm is the root of the energy: 1 % of it is 0.01 % of the energy.
  return fmt::format("  discretization    error about {:.2g} % in the energy norm, {:.2g} % of the energy\n",
                     100 * run.error->relative, 100 * run.error->relative * run.error->relative);
}

std::string probes_text(const std::vector<ProbeValues>& probes, const iga::ElasticityResults& results) {
  std::string text;
  for (const ProbeValues& probe : probes)
    text += fmt::format(
        "  {:<17} displacement {}, von Mises {}\n", probe.name,
        vector_with_unit(without_round_off(probe.values.displacement, results.max_displacement.value), "m"),
        with_uncertainty(probe.values.von_mises, probe.stress_error, results.max_von_mises.value));
  return text;
}

/// @param error  estimated, or none
std::string von_mises_text(const iga::ElasticityResults& results, const std::optional<RunError>& error,
                           double size) {
  std::string text = fmt::format("  max von Mises     {} at {} (of Gauss points and faces)\n",
                                 with_uncertainty(results.max_von_mises.value,
                                                  error ? std::optional(error->stress_at_max) : std::nullopt,
                                                  results.max_von_mises.value),
                                 place_with_unit(results.max_von_mises.place, size));
  if (error && error->singular)
    text += fmt::format("    grows           with refinement: it is at {}\n", *error->singular);
  const iga::LeftOut& left_out = results.left_out;
  if (left_out.folded > 0)
    text += fmt::format(
        "    without         {} points where patches are folded, the worst at {} in patch {}\n",
        with_separators(left_out.folded), place_with_unit(left_out.worst.place, size), left_out.worst.patch);
  if (left_out.collapsed > 0)
    text += fmt::format("    without         {} points on collapsed edges and faces\n",
                        with_separators(left_out.collapsed));
  return text;
}

std::string principal_text(const iga::ElasticityResults& results, double size) {
  const iga::StressPeaks& peaks = results.peaks;
  if (peaks.tension.patch < 0) return "";
  std::string text =
      fmt::format("  principal         from {} at {} to {} at {}\n  max Tresca        {} at {}\n",
                  with_unit(-peaks.compression.value, "Pa"), place_with_unit(peaks.compression.place, size),
                  with_unit(peaks.tension.value, "Pa"), place_with_unit(peaks.tension.place, size),
                  with_unit(peaks.tresca.value, "Pa"), place_with_unit(peaks.tresca.place, size));
  if (peaks.utilization.patch >= 0)
    text += fmt::format("  safety factor     {:.4g} against yield at {}\n", 1 / peaks.utilization.value,
                        place_with_unit(peaks.utilization.place, size));
  return text;
}

// Reactions' moments, where the study names a point for them, and the forces of cuts.
std::string moments_text(const Study& study, const CaseView& one, double size) {
  std::string text;
  const Eigen::Vector3d& point = study.output.moments_about;
  if (!point.isZero(0))
    for (const iga::Reaction& reaction : one.solution.results.reactions)
      text += fmt::format("  moment            {} about {} at {}\n",
                          vector_with_unit(moment_about(point, reaction), "N m"),
                          place_with_unit(point, size), reaction.support);
  for (const SectionValues& section : one.sections)
    text += fmt::format("  {:<17} {} and {} about {}, on {}\n", section.name,
                        vector_with_unit(section.forces.force, "N"),
                        vector_with_unit(section.forces.moment, "N m"),
                        place_with_unit(section.plane.point, size), with_unit(section.forces.area, "m^2"));
  return text;
}

std::string solver_text(const solvers::SolveReport& report) {
  // What was asked for by name and did as it was told needs no explanation.
  const std::string why =
      report.reason == "asked for by name" ? "" : fmt::format("  chosen            {}\n", report.reason);
  if (report.levels == 0)
    return fmt::format("  solver            {}, relative residual {:.2g}\n", solvers::name(report.method),
                       report.relative_residual) +
           why;
  return fmt::format(
             "  solver            {} with {} multigrid levels, {}: {} iterations to {:.2g} in energy\n",
             solvers::name(report.method), report.levels,
             report.form == solvers::Operator::assembled ? "matrix stored" : "matrix-free", report.iterations,
             report.energy_error) +
         why;
}

std::string case_heading(const CaseName& name) {
  if (name.name.empty()) return "";
  std::string of;
  for (const auto& [one, factor] : name.factors)
    of += fmt::format("{}{:g} {}",
                      of.empty()   ? ""
                      : factor < 0 ? " - "
                                   : " + ",
                      of.empty() ? factor : std::abs(factor), one);
  if (name.factors.empty())
    of = name.loads.empty() ? "what supports prescribe" : fmt::format("{}", fmt::join(name.loads, ", "));
  return fmt::format("{} {}: {}\n", name.factors.empty() ? "case" : "combination", name.name, of);
}

// Largest values, reactions and probes of one case.
std::string case_text(const Study& study, const StudyRun& run, const CaseView& one) {
  const iga::ElasticityResults& results = one.solution.results;
  const double size = run.built.problem.discretization.model.size();
  const bool is_estimated = &one.solution == &run.solution;
  return case_heading(one.name) +
         fmt::format("  max displacement  {} at {}\n", with_unit(results.max_displacement.value, "m"),
                     place_with_unit(results.max_displacement.place, size)) +
         von_mises_text(results, is_estimated ? run.error : std::nullopt, size) +
         principal_text(results, size) +
         fmt::format("  internal energy   {}\n", with_unit(results.internal_energy, "J")) +
         (is_estimated ? error_text(run) : "") + reactions_text(run, results) +
         moments_text(study, one, size) + probes_text(one.probes, results);
}

}  // namespace

std::string summary_json(const Study& study, const StudyRun& run) {
  Json json = {
      {"schema_version", 2},
      {"program", {{"name", "isopatch"}, {"version", version()}}},
      {"title", study.title},
      {"study", study.source},
      {"model", model_json(run)},
      {"materials", materials_json(study, run)},
      {"supports", supports_json(run.built.supports)},
      {"loads", loads_json(run.built.loads)},
      {"discretization", discretization_json(run, study.options.quadrature_points)},
      {"coupling", iga::name(study.options.coupling)},
      {"solver",
       solver_json(run.solution.solver, study.options.solver.tolerance, run.solution.predicted_bytes)},
      {"mass", mass_json(run.built.mass)},
      {"results", results_json(study, run, run.solution.results)},
      {"probes", probes_json(run.probes)},
      {"sections", sections_json(run.sections)},
      {"cases", cases_json(study, run)},
      {"warnings", texts_json(run.built.warnings)},
      {"warning_places", places_json(run.built.warnings)},
      {"timings", timings_json(run)},
      {"parallel", {{"processes", study.options.processes.count()}, {"threads", omp_get_max_threads()}}},
      {"memory", {{"peak_bytes", run.peak_bytes}}}};
  if (!run.levels.empty()) {
    json["levels"] = levels_json(run.levels);
    json["convergence"] = convergence_json(run.levels);
  }
  if (run.built.parameterization)
    json["parameterization"] = parameterization_json(*run.built.parameterization);
  return file_text(json);
}

std::string summary_text(const Study& study, const StudyRun& run) {
  const auto& model = run.built.problem.discretization.model;
  const iga::ProblemSize& size = run.solution.size;
  double total = 0;
  for (const iga::PhaseTime& time : run.timings) total += time.seconds;
  std::string text = study.title.empty() ? "" : study.title + "\n";
  const std::size_t bodies = run.built.report.bodies.size();
  text += fmt::format("  model             {} patches, {} interfaces, {} boundary faces, {}, volume {}\n",
                      model.patch_count(), model.interfaces().size(), model.boundary_faces().size(),
                      bodies == 1 ? "one body" : fmt::format("{} bodies", bodies),
                      with_unit(run.built.report.volume, "m^3"));
  if (run.built.mass)
    text += fmt::format("  mass              {}, centre at {}\n", with_unit(1e3 * run.built.mass->mass, "g"),
                        place_with_unit(run.built.mass->centre, model.size()));
  text += regions_text(run);
  text += fmt::format("  unknowns          {} ({} free), {} elements, coupled by {}\n",
                      with_separators(size.dofs), with_separators(size.dofs_free),
                      with_separators(size.elements), iga::name(study.options.coupling));
  text += solver_text(run.solution.solver);
  for (const CaseView& one : cases_of(run)) text += case_text(study, run, one);
  text += run_levels_text(run.levels);
  text += fmt::format("  time, memory      {}, {}{}\n", seconds_text(total), bytes_text(run.peak_bytes),
                      study.options.processes.count() == 1
                          ? ""
                          : fmt::format(" in {} processes", study.options.processes.count()));
  return text;
}

}  // namespace isopatch::app
