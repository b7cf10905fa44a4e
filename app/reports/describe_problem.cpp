#include "app/reports/describe_problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/engineering_units.hpp"
#include "geometry/measures.hpp"

namespace isopatch::app {
namespace {

std::string places_of(const AppliedRegion& region, bool all) {
  constexpr std::size_t short_list = 12;
  std::vector<std::string> names = region.edges.empty() ? region.faces : region.edges;
  for (const int patch : region.patches) names.push_back(fmt::format("patch {}", patch));
  const std::size_t total = names.size();
  if (!all && total > short_list) {
    names.resize(short_list);
    names.push_back(fmt::format("... and {} more (--all lists them)", total - short_list));
  }
  return fmt::format("    {}\n", fmt::join(names, region.patches.empty() ? " " : ", "));
}

std::string regions_text(const char* title, const std::vector<AppliedRegion>& regions, bool are_loads,
                         bool all) {
  if (regions.empty()) return "";
  std::string text = fmt::format("\n{}\n", title);
  for (const AppliedRegion& region : regions) {
    text += "  " + region_text(region);
    // What cancels out to rounding is no force.
    if (are_loads)
      text += ", in all " + vector_with_unit(without_round_off(region.total, region.total.norm()), "N");
    text += "\n" + places_of(region, all);
  }
  return text;
}

std::string probes_text(const BuiltProblem& problem) {
  const geometry::MultiPatch& model = problem.problem.discretization.model;
  std::string text = problem.probes.empty() ? "" : "\nprobes\n";
  for (const LocatedProbe& probe : problem.probes)
    text +=
        fmt::format("  {}: patch {}, {}\n", probe.name, probe.patch,
                    place_with_unit(model.patch(PatchId(probe.patch)).point(probe.parameter), model.size()));
  return text;
}

// Faces with other elements on either side, T-joints and those of [[discretization.patch]] alike.
std::string apart_text(const ModelReport& report, bool all) {
  constexpr std::size_t short_list = 4;
  const std::size_t total = report.non_matching.size();
  if (total == 0) return "";
  std::vector<std::string> pairs;
  for (const NonMatchingReport& pair : report.non_matching)
    pairs.push_back(fmt::format("{} and {}", pair.first, pair.second));
  if (!all && total > short_list) {
    pairs.resize(short_list);
    pairs.push_back(fmt::format("... and {} more (--all lists them)", total - short_list));
  }
  return fmt::format("faces that will not match: {}\n", fmt::join(pairs, ", "));
}

}  // namespace

std::string problem_text(const BuiltProblem& problem, bool all) {
  const iga::Discretization& discretization = problem.problem.discretization;
  return regions_text("supports", problem.supports, false, all) +
         regions_text("loads", problem.loads, true, all) + probes_text(problem) +
         fmt::format("\nto be solved with {} elements and {} control points\n",
                     with_separators(discretization.element_count()),
                     with_separators(discretization.node_count())) +
         apart_text(problem.report, all);
}

}  // namespace isopatch::app
