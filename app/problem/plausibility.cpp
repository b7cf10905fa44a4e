#include "app/problem/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <variant>

#include "app/base/engineering_units.hpp"
#include "app/problem/resolution_warning.hpp"
#include "geometry/base/dense_matrices.hpp"

namespace isopatch::app {
namespace {

constexpr double softest = 1e6;     // Pa: soft rubber
constexpr double hardest = 1.3e12;  // Pa: above diamond
constexpr double most_strain = 0.1;

template <class Items>
void add_shared_names(const Items& items, const char* what, std::vector<Warning>& warnings) {
  std::map<std::string, int> counts;
  for (const auto& item : items) ++counts[item.key];
  for (const auto& [name, count] : counts)
    if (count > 1)
      warnings.push_back(
          {fmt::format("{} {} have the name \"{}\"; results cannot be told apart by it", count, what, name)});
}

std::string material_name(const iga::Material& material, std::size_t index) {
  return material.name.empty() ? fmt::format("material {}", index + 1)
                               : fmt::format("material '{}'", material.name);
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
  for (const auto& [name, count] : counts)
    if (count > 1)
      warnings.push_back(
          {fmt::format("{} probes have the name \"{}\"; results cannot be told apart by it", count, name)});
  for (std::size_t i = 0; i < study.materials.size(); ++i) {
    const iga::Material& material = study.materials[i].material;
    const double modulus = iga::young(material);
    if (modulus >= softest && modulus <= hardest) continue;
    warnings.push_back({fmt::format(
        "Young's modulus of {} is {}, {} than that of any solid (1 MPa of soft rubber to 1.2 TPa of "
        "diamond); "
        "plain numbers are Pa: steel is 210e9 or \"210 GPa\"",
        material_name(material, i), with_unit(modulus, "Pa"), modulus < softest ? "less" : "more")});
  }
  return warnings;
}

std::vector<Warning> result_warnings(const BuiltProblem& built, const iga::ElasticitySolution& solution) {
  std::vector<Warning> warnings;
  add_imbalance(built, solution.results, warnings);
  add_idle_loads(solution.results, warnings);
  add_large_displacement(built, solution.results, warnings);
  add_large_strain(built, solution, warnings);
  add_left_out(built, solution.results, warnings);
  if (auto warning = resolution_warning(built.problem, solution.results)) warnings.push_back(*warning);
  return warnings;
}

}  // namespace isopatch::app
