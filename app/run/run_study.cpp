#include "app/run/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/base/provenance.hpp"
#include "app/problem/plausibility.hpp"
#include "app/run/estimate_error.hpp"
#include "app/study/load_cases.hpp"
#include "geometry/base/stopwatch.hpp"

namespace isopatch::app {
namespace {

// A place in the model that was found is on the other side's face to a share of the tolerance of interfaces.
void add_sides(const geometry::MultiPatch& model, const iga::ElasticField& field, ProbeValues& probe) {
  for (const iga::Location& side :
       iga::locate_sides(field, probe.values.place, model.tolerance().same_point * model.size()))
    if (const auto p = static_cast<std::size_t>(side.patch);
        field.materials[p] != field.materials[static_cast<std::size_t>(probe.patch)])
      probe.sides.push_back({side.patch, model.to_input(PatchId(side.patch), side.parameter),
                             field.materials[p].name, iga::evaluate(field, side.patch, side.parameter)});
}

std::vector<ProbeValues> probe_values(const BuiltProblem& built, const iga::ElasticField& field) {
  const auto& model = built.problem.discretization.model;
  std::vector<ProbeValues> result;
  for (const LocatedProbe& probe : built.probes) {
    result.push_back({probe.name, probe.patch, model.to_input(PatchId(probe.patch), probe.parameter),
                      iga::evaluate(field, probe.patch, probe.parameter)});
    add_sides(model, field, result.back());
  }
  return result;
}

std::vector<SectionValues> section_values(const BuiltProblem& built, const iga::ElasticField& field) {
  std::vector<SectionValues> result;
  for (const LocatedSection& section : built.sections)
    result.push_back(
        {section.name, section.plane, iga::section_forces(field, section.plane, section.points)});
  return result;
}

std::vector<CaseName> case_names(const Study& study, const iga::LoadCases& cases) {
  std::vector<CaseName> result;
  for (const iga::LoadCase& one : cases.cases) {
    result.push_back({one.name, {}, {}});
    for (const AppliedLoad& load : study.loads)
      if (std::find(one.loads.begin(), one.loads.end(), load.name) != one.loads.end())
        result.back().loads.push_back(load.key);
  }
  for (const iga::LoadCombination& sum : cases.combinations) {
    result.push_back({sum.name, {}, {}});
    for (std::size_t i = 0; i < sum.factors.size(); ++i)
      if (sum.factors[i] != 0) result.back().factors.emplace_back(cases.cases[i].name, sum.factors[i]);
  }
  return result;
}

void add_warnings(const std::string& name, std::vector<Warning> warnings, std::vector<Warning>& all) {
  for (Warning& warning : warnings) {
    if (!name.empty()) warning.text = fmt::format("case {}: {}", name, warning.text);
    all.push_back(std::move(warning));
  }
}

}  // namespace

StudyRun run_study(const Study& study, const Progress& progress) {
  load_cases(study);  // throws before anything takes long
  const Stopwatch reading;
  const ReportedModel model = reported_model(study, progress);
  const double seconds = reading.seconds();
  StudyRun run = run_study(study, model, progress);
  run.timings.front().seconds += seconds;
  return run;
}

StudyRun run_study(const Study& study, const ReportedModel& model, const Progress& progress) {
  const iga::LoadCases cases = load_cases(study);
  const Stopwatch building;
  StudyRun run{build_problem(study, model.loaded, model.report, progress), {}, {}, {}, 0};
  warn_of_no_load(study, run.built);
  run.timings.push_back({"model", building.seconds()});
  if (cases.cases.empty()) {
    run.solution = iga::solve_elasticity(run.built.problem, study.options, progress);
  } else {
    std::vector<iga::ElasticitySolution> solutions =
        iga::solve_cases(run.built.problem, cases, study.options, progress);
    std::vector<CaseName> names = case_names(study, cases);
    run.solution = std::move(solutions.front());
    run.case_name = std::move(names.front());
    for (std::size_t i = 1; i < solutions.size(); ++i)
      run.further.push_back({std::move(names[i]), std::move(solutions[i]), {}});
  }
  for (const iga::PhaseTime& time : run.solution.timings) run.timings.push_back(time);
  run.probes = probe_values(run.built, run.solution.field);
  run.sections = section_values(run.built, run.solution.field);
  for (CaseRun& other : run.further) {
    other.probes = probe_values(run.built, other.solution.field);
    other.sections = section_values(run.built, other.solution.field);
  }
  if (study.output.error_estimate) estimate_errors(study, cases, run, progress);
  std::vector<Warning> warnings;
  for (const CaseView& one : cases_of(run))
    add_warnings(one.name.name,
                 result_warnings(run.built, one.solution,
                                 one.error ? std::optional(one.error->relative) : std::nullopt),
                 warnings);
  add_warnings("", std::move(warnings), run.built.warnings);
  run.peak_bytes = study.options.processes.sum(peak_memory_bytes());
  return run;
}

}  // namespace isopatch::app
