#include "app/results/summary.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <optional>

#include "app/base/provenance.hpp"
#include "app/problem/resolution_warning.hpp"
#include "app/problem/selection.hpp"
#include "app/results/internal/json_regions.hpp"
#include "app/results/internal/levels_json.hpp"
#include "app/results/internal/parameterization_json.hpp"
#include "app/results/internal/stages_json.hpp"
#include "app/results/level_report.hpp"
#include "app/results/stress_round_off.hpp"
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
  Json apart = Json::array();
  for (const NonMatchingReport& pair : report.non_matching)
    apart.push_back({{"first", pair.first},
                     {"second", pair.second},
                     {"area", pair.area},
                     {"area_error", pair.area_error},
                     {"gap", pair.gap}});
  return {{"patches", model.patch_count()},
          {"interfaces", model.interfaces().size()},
          {"non_matching_interfaces", model.non_matching().size()},
          {"non_matching", apart},
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
                      {"area", region.area},
                      {"is_part", region.is_part},
                      {"points", region.points},
                      {"length", region.length}});
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

Json reactions_json(const StudyRun& run, const iga::ElasticityResults& results,
                    const Eigen::Vector3d& point) {
  Json reactions = Json::array();
  for (std::size_t i = 0; i < run.built.supports.size(); ++i) {
    const iga::Reaction& reaction = results.reactions[i];
    reactions.push_back({{"support", run.built.supports[i].key},
                         {"force", to_json(reaction.force)},
                         {"moment", to_json(reaction.moment)},
                         {"moment_about_point", to_json(reaction.moment_about(point))}});
  }
  return reactions;
}

Json error_json(const std::optional<RunError>& error, const std::string& missing) {
  if (!error) return missing.empty() ? Json(nullptr) : Json{{"missing", missing}};
  return {{"energy_norm", error->relative},
          {"energy", error->energy},
          {"max_von_mises", iga::von_mises(error->stress_at_max)},
          {"singular", error->singular ? Json(*error->singular) : Json(nullptr)},
          {"iterations", error->iterations}};
}

// What holds faces to others that they do not match.
Json mortar_json(const geometry::MultiPatch& model, const std::vector<iga::MortarTie>& ties) {
  Json result = Json::array();
  for (const iga::MortarTie& tie : ties) {
    Json masters = Json::array();
    for (const geometry::PatchFace& face : tie.face.masters) masters.push_back(model.label(face));
    result.push_back({{"face", model.label(tie.face.slave)},
                      {"covered_by", masters},
                      {"reason", tie.face.reason},
                      {"multipliers", tie.multipliers},
                      {"force", to_json(tie.force)}});
  }
  return result;
}

Json results_json(const Study& study, const StudyRun& run, const CaseView& one) {
  const iga::ElasticityResults& results = one.solution.results;
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
          {"interface_energy", results.interface_energy},
          {"mortar", mortar_json(model, one.solution.mortar)},
          {"external_work", results.external_work},
          {"thermal_work", results.thermal_work},
          {"max_von_mises", results.max_von_mises.value},
          {"max_von_mises_point", to_json(results.max_von_mises.place)},
          {"max_von_mises_at", at(results.max_von_mises)},
          {"max_von_mises_sampled", "at Gauss points and on faces"},
          {"stress_round_off", stress_round_off(run.built.problem, results)},
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
          {"discretization_error", error_json(one.error, run.error_missing)},
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
    if (probe.singular) result.back()["singular"] = *probe.singular;
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
  std::size_t index = 0;
  for (const CaseView& one : cases_of(run)) {
    Json factors = Json::object();
    for (const auto& [name, factor] : one.name.factors) factors[name] = factor;
    result.push_back({{"name", one.name.name},
                      {"kind", one.name.factors.empty() ? "case" : "combination"},
                      {"loads", one.name.loads},
                      {"factors", factors},
                      {"results", results_json(study, run, one)},
                      {"probes", probes_json(one.probes)},
                      {"sections", sections_json(one.sections)},
                      {"solver", solver_json(one.solution.solver, study.options.solver.tolerance,
                                             one.solution.predicted_bytes)}});
    if (!run.levels.empty()) {
      const std::vector<RunLevel> levels = levels_of_case(run.levels, index);
      result.back()["levels"] = levels_json(levels);
      result.back()["convergence"] = convergence_json(levels);
    }
    ++index;
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
      {"non_matching_coupling", run.built.problem.discretization.model.non_matching().empty()
                                    ? "none"
                                    : iga::name(study.options.non_matching)},
      {"solver",
       solver_json(run.solution.solver, study.options.solver.tolerance, run.solution.predicted_bytes)},
      {"mass", mass_json(run.built.mass)},
      {"results", results_json(study, run, cases_of(run).front())},
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
  if (run.accuracy) json["accuracy"] = accuracy_json(*run.accuracy);
  if (!run.built.stages.empty()) json["stages"] = stages_json(run.built.stages);
  if (run.built.parameterization)
    json["parameterization"] = parameterization_json(*run.built.parameterization);
  return file_text(json);
}

}  // namespace isopatch::app
