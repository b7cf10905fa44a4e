#include "app/results/summary_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/base/engineering_units.hpp"
#include "app/results/level_report.hpp"
#include "app/results/stress_round_off.hpp"
#include "iga/post/stress_measures.hpp"

namespace isopatch::app {
namespace {

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

// What stresses are seen beside.
double stress_scale(const iga::ElasticityProblem& problem, const iga::ElasticityResults& results) {
  return std::max(results.max_von_mises.value, 1e10 * stress_round_off(problem, results));
}

std::string stress_text(double value, double scale) {
  return with_unit(without_round_off(value, scale), "Pa");
}

// "12.34 +- 0.5 MPa"; the value alone where nothing is known of its error, or both are round-off.
std::string estimated_text(double value, const std::optional<Eigen::Matrix3d>& stress_error, double scale) {
  const double error = stress_error ? without_round_off(iga::von_mises(*stress_error), scale) : 0;
  if (!stress_error || (error == 0 && without_round_off(value, scale) == 0)) return stress_text(value, scale);
  return with_uncertainty(without_round_off(value, scale), error, "Pa");
}

std::string error_text(const std::optional<RunError>& error, const std::string& missing) {
  if (!error)
    return missing.empty() ? ""
                           : fmt::format("  discretization    its error is not estimated: {}\n", missing);
  // The norm is the root of the energy: 1 % of it is 0.01 % of the energy.
  return fmt::format("  discretization    error about {:.2g} % in the energy norm, {:.2g} % of the energy\n",
                     100 * error->relative, 100 * error->relative * error->relative);
}

/// @param scale  of stresses
std::string probes_text(const std::vector<ProbeValues>& probes, const iga::ElasticityResults& results,
                        double scale) {
  std::string text;
  for (const ProbeValues& probe : probes)
    text +=
        fmt::format("  {:<17} displacement {}, von Mises {}\n", probe.name,
                    vector_with_unit(
                        without_round_off(probe.values.displacement, results.max_displacement.value), "m"),
                    estimated_text(probe.values.von_mises, probe.stress_error, scale)) +
        (probe.singular ? fmt::format("    grows           with refinement: it is at {}\n", *probe.singular)
                        : "");
  return text;
}

/// @param error  estimated, or none
/// @param scale  of stresses
std::string von_mises_text(const iga::ElasticityResults& results, const std::optional<RunError>& error,
                           double size, double scale) {
  std::string text =
      fmt::format("  max von Mises     {} at {} (of Gauss points and faces)\n",
                  estimated_text(results.max_von_mises.value,
                                 error ? std::optional(error->stress_at_max) : std::nullopt, scale),
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

std::string principal_text(const iga::ElasticityResults& results, double size, double scale) {
  const iga::StressPeaks& peaks = results.peaks;
  if (peaks.tension.patch < 0) return "";
  std::string text = fmt::format(
      "  principal         from {} at {} to {} at {}\n  max Tresca        {} at {}\n",
      stress_text(-peaks.compression.value, scale), place_with_unit(peaks.compression.place, size),
      stress_text(peaks.tension.value, scale), place_with_unit(peaks.tension.place, size),
      stress_text(peaks.tresca.value, scale), place_with_unit(peaks.tresca.place, size));
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
                          vector_with_unit(reaction.moment_about(point), "N m"), place_with_unit(point, size),
                          reaction.support);
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
  return fmt::format("  solver            {} with {}, {}: {} to {:.2g} in energy\n",
                     solvers::name(report.method), counted(report.levels, "multigrid level"),
                     report.form == solvers::Operator::assembled ? "matrix stored" : "matrix-free",
                     counted(report.iterations, "iteration"), report.energy_error) +
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

// Nitsche's method stores energy between faces: without it that of the part is not the work.
std::string balance_text(const Study& study, const geometry::MultiPatch& model,
                         const iga::ElasticityResults& results) {
  if (model.non_matching().empty() || study.options.non_matching != iga::NonMatchingCoupling::nitsche)
    return "";
  const double work = results.external_work + results.thermal_work;
  const double scale = std::max(std::abs(results.internal_energy), std::abs(work));
  const auto energy = [&](double joule) { return with_unit(without_round_off(joule, scale), "J"); };
  return fmt::format(
      "    balance         with {} of Nitsche's method between faces{}: the work is {}\n",
      energy(results.interface_energy),
      results.support_energy == 0 ? "" : fmt::format(" and {} in springs", energy(results.support_energy)),
      energy(work));
}

// Largest values, reactions and probes of one case.
std::string case_text(const Study& study, const StudyRun& run, const CaseView& one) {
  const iga::ElasticityResults& results = one.solution.results;
  const double size = run.built.problem.discretization.model.size();
  const double scale = stress_scale(run.built.problem, results);
  return case_heading(one.name) +
         fmt::format("  max displacement  {} at {}\n", with_unit(results.max_displacement.value, "m"),
                     place_with_unit(results.max_displacement.place, size)) +
         von_mises_text(results, one.error, size, scale) + principal_text(results, size, scale) +
         fmt::format("  internal energy   {}\n", with_unit(results.internal_energy, "J")) +
         balance_text(study, run.built.problem.discretization.model, results) +
         error_text(one.error, run.error_missing) + reactions_text(run, results) +
         moments_text(study, one, size) + probes_text(one.probes, results, scale);
}

// Where the mortar method has its multipliers: face by face as far as there are few.
std::string mortar_text(const geometry::MultiPatch& model, const std::vector<iga::MortarTie>& ties) {
  constexpr std::size_t shown = 4;
  std::string text;
  for (std::size_t i = 0; i < ties.size() && i < shown; ++i)
    text += fmt::format("{}{} ({})", i == 0 ? "  multipliers on    " : ", ", model.label(ties[i].face.slave),
                        ties[i].face.reason);
  if (ties.size() > shown) text += fmt::format(" and {} more: summary.json", ties.size() - shown);
  return text.empty() ? "" : text + "\n";
}

std::string coupling_text(const Study& study, const geometry::MultiPatch& model) {
  return fmt::format("{}{}", iga::name(study.options.coupling),
                     model.non_matching().empty() ? ""
                     : study.options.non_matching == iga::NonMatchingCoupling::mortar
                         ? " and mortar multipliers"
                         : " and Nitsche's method");
}

// A key that does nothing here; T-joints can be kept with it alone, so it is theirs as well.
std::string nothing_to_couple_text(const Study& study, const geometry::MultiPatch& model) {
  if (!study.model.tolerance.keep_non_matching || !model.non_matching().empty()) return "";
  return fmt::format("  not matching      nothing: {}, and coupling.non_matching has nothing to couple\n",
                     model.patch_count() == 1 ? "there is one patch" : "all patches meet side to side");
}

// A table for each case.
std::string levels_text(const StudyRun& run) {
  if (!run.has_cases() || run.levels.empty()) return run_levels_text(run.levels);
  std::string text;
  std::size_t index = 0;
  for (const CaseView& one : cases_of(run))
    text += fmt::format("levels of {} {}\n{}", one.name.factors.empty() ? "case" : "combination",
                        one.name.name, run_levels_text(levels_of_case(run.levels, index++)));
  return text;
}

}  // namespace

std::string non_matching_text(const ModelReport& report) {
  constexpr std::size_t shown = 4;
  std::string text;
  for (std::size_t i = 0; i < report.non_matching.size() && i < shown; ++i)
    text += fmt::format("{}{} and {}", i == 0 ? "  not matching      " : ", ", report.non_matching[i].first,
                        report.non_matching[i].second);
  if (report.non_matching.size() > shown)
    text += fmt::format(" and {} more: isopatch info", report.non_matching.size() - shown);
  return text.empty() ? "" : text + "\n";
}

std::string summary_text(const Study& study, const StudyRun& run) {
  const auto& model = run.built.problem.discretization.model;
  const iga::ProblemSize& size = run.solution.size;
  double total = 0;
  for (const iga::PhaseTime& time : run.timings) total += time.seconds;
  std::string text = study.title.empty() ? "" : study.title + "\n";
  text += fmt::format("  model             {}, volume {}\n", contents_text(model, run.built.report),
                      with_unit(run.built.report.volume, "m^3"));
  text += non_matching_text(run.built.report) + nothing_to_couple_text(study, model);
  if (!run.built.stages.empty())
    text += fmt::format("  stages            {}\n", stages_text(run.built.stages));
  if (run.built.mass)
    text += fmt::format("  mass              {}, centre at {}\n", with_unit(1e3 * run.built.mass->mass, "g"),
                        place_with_unit(run.built.mass->centre, model.size()));
  text += regions_text(run);
  text += fmt::format("  unknowns          {} ({} free), {} elements, coupled by {}\n",
                      with_separators(size.dofs), with_separators(size.dofs_free),
                      with_separators(size.elements), coupling_text(study, model));
  text += mortar_text(model, run.solution.mortar);
  text += solver_text(run.solution.solver);
  for (const CaseView& one : cases_of(run)) text += case_text(study, run, one);
  text += levels_text(run);
  if (run.accuracy) text += fmt::format("  accuracy          {}\n", accuracy_text(*run.accuracy));
  text += fmt::format("  time, memory      {}, {}{}\n", seconds_text(total), bytes_text(run.peak_bytes),
                      study.options.processes.count() == 1
                          ? ""
                          : fmt::format(" in {} processes", study.options.processes.count()));
  return text;
}

}  // namespace isopatch::app
