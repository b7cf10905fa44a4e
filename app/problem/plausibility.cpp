#include "app/problem/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "app/base/engineering_units.hpp"
#include "app/problem/resolution_warning.hpp"
#include "geometry/base/dense_matrices.hpp"

namespace isopatch::app {
namespace {

// What solids have of a property.
struct SolidRange {
  const char* name;
  double (*value)(const iga::Material&);
  const char* unit;
  double least, most;
  const char* ends;  // the solids at both
  const char* advice;
};
const SolidRange solid_ranges[] = {
    {"Young's modulus", iga::young, "Pa", 1e6, 1.3e12, "1 MPa of soft rubber to 1.2 TPa of diamond",
     "plain numbers are Pa: steel is 210e9 or \"210 GPa\""},
    {"the density", [](const iga::Material& m) { return m.density; }, "kg/m^3", 10, 23e3,
     "10 kg/m^3 of foam to 23,000 of osmium", "plain numbers are kg/m^3: steel is 7850 or \"7.85 g/cm^3\""},
    {"the yield stress", [](const iga::Material& m) { return m.yield; }, "Pa", 1e4, 2e11,
     "10 kPa of foam to some 100 GPa of diamond", "plain numbers are Pa: steel is 355e6 or \"355 MPa\""},
    {"the thermal expansion", [](const iga::Material& m) { return std::abs(m.expansion); }, "1/K", 1e-9, 1e-3,
     "below 1e-9 of glass ceramics to 1e-3 of soft rubber", "steel is 12e-6 or \"12e-6 1/K\""},
};
constexpr double most_strain = 0.1;

void add_shared(const std::map<std::string, int>& counts, const char* what, std::vector<Warning>& warnings) {
  for (const auto& [name, count] : counts)
    if (count > 1)
      warnings.push_back(
          {fmt::format("{} {} have the name \"{}\"; results cannot be told apart by it", count, what, name)});
}

template <class Items>
void add_shared_names(const Items& items, const char* what, std::vector<Warning>& warnings) {
  std::map<std::string, int> counts;
  for (const auto& item : items) ++counts[item.key];
  add_shared(counts, what, warnings);
}

std::string material_name(const iga::Material& material, std::size_t index) {
  return material.name.empty() ? fmt::format("material {}", index + 1)
                               : fmt::format("material '{}'", material.name);
}

// What is 0 is not given.
void add_unlike_solids(const iga::Material& material, std::size_t index, std::vector<Warning>& warnings) {
  for (const SolidRange& range : solid_ranges) {
    const double value = range.value(material);
    if (value == 0 || (value >= range.least && value <= range.most)) continue;
    const std::string text = range.unit == std::string_view("Pa")
                                 ? with_unit(value, "Pa")
                                 : fmt::format("{:.4g} {}", value, range.unit);
    warnings.push_back({fmt::format("{} of {} is {}, {} than that of any solid ({}); {}", range.name,
                                    material_name(material, index), text,
                                    value < range.least ? "less" : "more", range.ends, range.advice)});
  }
}

void add_idle_loads(const iga::ElasticityResults& results, std::vector<Warning>& warnings) {
  for (const std::string& name : results.idle_loads)
    warnings.push_back({fmt::format(
        "{} moves nothing: supports hold all its faces in the direction in which it acts and take all of it",
        name)});
}

void add_large_displacement(const BuiltProblem& built, const iga::ElasticityResults& results,
                            std::vector<Warning>& warnings) {
  const double size = built.report.box.diagonal().norm();
  const iga::Extremum& most = results.max_displacement;
  if (!(most.value > size)) return;
  warnings.push_back(
      {fmt::format("the largest displacement, {}, is more than the part's size, {}: look at the "
                   "units of loads, materials and lengths",
                   with_unit(most.value, "m"), with_unit(size, "m")),
       most.patch, most.place});
}

void add_large_strain(const BuiltProblem& built, const iga::ElasticitySolution& solution,
                      std::vector<Warning>& warnings) {
  const iga::Extremum& most = solution.results.max_strain;
  if (most.patch < 0 || !(most.value > most_strain)) return;
  const Eigen::Matrix3d strain = iga::evaluate(solution.field, most.patch, most.parameter).strain;
  const double largest = principal_axes(strain).values.cwiseAbs().maxCoeff();
  if (!(largest > most_strain)) return;
  warnings.push_back(
      {fmt::format("strains come to {:.3g} % at {}: linear elasticity is for small ones, below some "
                   "{:.0f} %",
                   100 * largest, place_with_unit(most.place, built.problem.discretization.model.size()),
                   100 * most_strain),
       most.patch, most.place});
}

void add_left_out(const BuiltProblem& built, const iga::ElasticityResults& results,
                  std::vector<Warning>& warnings) {
  const iga::LeftOut& left_out = results.left_out;
  if (left_out.folded == 0) return;
  warnings.push_back(
      {fmt::format(
           "{} of the points where stresses are compared lie where patches are folded, the worst at {} in "
           "patch "
           "{} (scaled Jacobian {:.3g}); their stresses say nothing and are left out of the largest one",
           with_separators(left_out.folded),
           place_with_unit(left_out.worst.place, built.problem.discretization.model.size()),
           left_out.worst.patch, -left_out.worst.value),
       left_out.worst.patch, left_out.worst.place});
}

// What the points that hold a free body have to take.
void add_imbalance(const BuiltProblem& built, const iga::ElasticityResults& results,
                   std::vector<Warning>& warnings) {
  constexpr double unbalanced = 1e-6;  // of all loads and reactions: their numbers have six digits
  double forces = results.load_size;
  for (const iga::Reaction& reaction : results.reactions) forces += reaction.force.norm();
  const double size = built.report.box.diagonal().norm();
  for (std::size_t s = 0; s < results.reactions.size(); ++s) {
    if (!std::holds_alternative<iga::FreeBodySupport>(built.problem.supports[s].condition)) continue;
    const iga::Reaction& reaction = results.reactions[s];
    const double left = std::max(reaction.force.norm(), reaction.moment.norm() / size);
    if (!(left > unbalanced * forces)) continue;
    warnings.push_back({fmt::format(
        "{}: the loads do not balance: a force of {} and a moment of {} about the origin are "
        "left, which single points take; stresses near them grow without limit",
        reaction.support, with_unit(reaction.force.norm(), "N"), with_unit(reaction.moment.norm(), "N m"))});
  }
}

}  // namespace

std::vector<Warning> input_warnings(const Study& study) {
  std::vector<Warning> warnings;
  add_shared_names(study.supports, "supports", warnings);
  add_shared_names(study.loads, "loads", warnings);
  std::map<std::string, int> counts;
  for (const ProbeInput& probe : study.probes) ++counts[probe.name];
  add_shared(counts, "probes", warnings);
  counts.clear();
  for (const SectionInput& section : study.sections) ++counts[section.name];
  add_shared(counts, "sections", warnings);
  for (std::size_t i = 0; i < study.materials.size(); ++i)
    add_unlike_solids(study.materials[i].material, i, warnings);
  return warnings;
}

std::vector<Warning> result_warnings(const BuiltProblem& built, const iga::ElasticitySolution& solution,
                                     const std::optional<double>& error) {
  constexpr double small_error = 0.02;  // 0.04 % of the energy
  std::vector<Warning> warnings;
  add_imbalance(built, solution.results, warnings);
  add_idle_loads(solution.results, warnings);
  add_large_displacement(built, solution.results, warnings);
  add_large_strain(built, solution, warnings);
  add_left_out(built, solution.results, warnings);
  if (auto warning = pressure_warning(built.problem)) warnings.push_back(*warning);
  if (error && *error < small_error) return warnings;
  if (auto warning = resolution_warning(built.problem, solution.results)) warnings.push_back(*warning);
  return warnings;
}

}  // namespace isopatch::app
