#include "app/run/run_accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "app/run/if_it_fits.hpp"
#include "iga/estimate/refinement.hpp"

namespace isopatch::app {
namespace {

// Control points of a refinement, at most, as a multiple of those before: an estimate that is far from its
// goal says little about where the last elements will be needed.
constexpr double most_growth = 4;
// Errors of what is yet unresolved shrink less than the estimate promises.
constexpr double aim = 0.9;

// Errors of stresses are relative to the stress there, or to this share of the largest one if that is more.
constexpr double least_stress = 0.01;
// Errors that two refinements leave at this share do not become smaller.
constexpr double no_less = 0.97;

// An error of a case as a share of the goal, and why it cannot become smaller, if it cannot.
struct Distance {
  double of_goal = 0;
  std::optional<std::string> singular = {};
  double stress = 0;  // the one that is asked for, Pa
};

double share(double error, double value) {
  if (value > 0) return error / value;
  return error > 0 ? std::numeric_limits<double>::infinity() : 0;
}

Distance stress_distance(const AccuracyInput& asked, const CaseView& of) {
  const double largest = of.solution.results.max_von_mises.value;
  if (asked.probe.empty())
    return {share(iga::von_mises(of.error->stress_at_max), largest) / *asked.stress, of.error->singular,
            largest};
  for (const ProbeValues& probe : of.probes)
    if (probe.name == asked.probe)
      return {share(iga::von_mises(*probe.stress_error),
                    std::max(probe.values.von_mises, least_stress * largest)) /
                  *asked.stress,
              probe.singular, probe.values.von_mises};
  return {};
}

// A stress is known no better than the last refinement has changed it, which tells of those without a limit
// too.
Distance distance(const AccuracyInput& asked, const CaseView& of, std::map<std::string, double>& stresses) {
  Distance result;
  if (asked.stress) {
    result = stress_distance(asked, of);
    if (const auto before = stresses.find(of.name.name); before != stresses.end())
      result.of_goal = std::max(
          result.of_goal, share(std::abs(result.stress - before->second), result.stress) / *asked.stress);
    stresses[of.name.name] = result.stress;
  }
  if (asked.energy) result.of_goal = std::max(result.of_goal, of.error->relative / *asked.energy);
  return result;
}

// The case that is farthest from its goal.
struct Worst {
  const iga::ElasticField* field = nullptr;
  Distance distance;
  std::string name;
};

// @param stresses  those before, by case; and those now
Worst worst_of(const AccuracyInput& asked, const StudyRun& run, std::map<std::string, double>& stresses) {
  Worst worst;
  for (const CaseView& one : cases_of(run)) {
    const Distance here = distance(asked, one, stresses);
    if (!worst.field || here.of_goal > worst.distance.of_goal)
      worst = {&one.solution.field, here, one.name.name};
  }
  return worst;
}

void check_probe(const Study& study) {
  const std::string& name = study.accuracy.probe;
  const auto is_it = [&](const ProbeInput& probe) { return probe.name == name; };
  if (name.empty() || std::any_of(study.probes.begin(), study.probes.end(), is_it)) return;
  throw error_at(study.accuracy.place,
                 fmt::format("accuracy.probe is \"{}\", and no [[probe]] has that name", name));
}

// What ends the work short of the goal.
// @param distances  from the goal so far
std::string no_further(const AccuracyInput& asked, const Worst& worst, const std::vector<double>& distances) {
  const std::string of_case = worst.name.empty() ? "" : fmt::format(" of case {}", worst.name);
  if (worst.distance.singular && asked.stress)
    return fmt::format("the stress there{} grows with every refinement: {}", of_case,
                       *worst.distance.singular);
  const std::size_t refinements = distances.size() - 1;
  if (refinements >= 2 && distances.back() > no_less * distances[refinements - 2])
    return fmt::format(
        "two refinements have not made the error{} smaller, as where points or lines are held or loaded",
        of_case);
  if (refinements >= static_cast<std::size_t>(asked.refinements))
    return fmt::format("accuracy.refinements is {}", asked.refinements);
  return "";
}

// More knots for the next solution.
std::vector<iga::KnotPlace> next_knots(const StudyRun& run, const Worst& worst, bool spread) {
  const double ratio = aim / worst.distance.of_goal;
  double energy = 0;
  for (const iga::ElementErrors& of_patch : worst.field->errors) energy += of_patch.along.sum();
  return iga::knots_to_add(run.built.problem.discretization, worst.field->errors, ratio * ratio * energy,
                           most_growth, spread);
}

}  // namespace

StudyRun run_accuracy(const Study& study, const std::function<void(StudyRun&)>& keep,
                      const Progress& progress) {
  check_probe(study);
  const bool is_alone = study.options.processes.count() == 1;
  Study refined = study;
  refined.output.error_estimate = true;
  const ReportedModel model = reported_model(study, progress);
  std::vector<RunLevel> levels;
  std::vector<double> distances;
  std::map<std::string, double> stresses;
  std::optional<StudyRun> last;
  const auto ended = [&](const std::string& missing) {
    last->accuracy->missing = missing;
    if (!missing.empty())
      last->built.warnings.push_back({"the accuracy that is asked for is not reached: " + missing});
    add_coarser_levels(*last);
    return std::move(*last);
  };
  for (int refinements = 0;; ++refinements) {
    std::string reason;
    const auto solve = [&] { return run_study(refined, model, progress); };
    auto run = last && is_alone ? if_it_fits(solve, reason) : std::optional(solve());
    if (!run) return ended("there is no memory for the next refinement: " + reason);
    if (last && !run->error_missing.empty())
      return ended("there would be no estimate after the next refinement: " + run->error_missing);
    last = std::move(run);
    levels.push_back(run_level(*last, refinements));
    levels.back().is_adaptive = true;
    last->levels = levels;
    last->accuracy = AccuracyOutcome{.asked = study.accuracy};
    if (!last->error_missing.empty()) return ended("the error cannot be estimated: " + last->error_missing);
    const Worst worst = worst_of(study.accuracy, *last, stresses);
    if (worst.distance.of_goal <= 1) return ended("");
    distances.push_back(worst.distance.of_goal);
    if (const std::string why = no_further(study.accuracy, worst, distances); !why.empty()) return ended(why);
    const std::vector<iga::KnotPlace> more = next_knots(*last, worst, refined.discretization.spread);
    if (more.empty()) return ended("no elements are left that could be halved");
    refined.discretization.knots.insert(refined.discretization.knots.end(), more.begin(), more.end());
    last->accuracy->missing = "the refinements that follow were not finished";
    keep(*last);
  }
}

}  // namespace isopatch::app
