#include "iga/problem/load_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void require_known(const std::vector<std::string>& names, const std::set<std::string>& known,
                   const LoadCase& load_case, const char* what) {
  for (const std::string& name : names)
    if (known.count(name) == 0)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("case '{}' has the {} '{}', which the problem does not have", load_case.name,
                              what, name));
}

void hold_still(Support& support) {
  if (auto* prescribed = std::get_if<PrescribedDisplacement>(&support.condition)) {
    for (std::optional<double>& value : prescribed->value)
      if (value) value = 0;
    prescribed->gradient.setZero();
  }
  if (auto* plane = std::get_if<PlaneSupport>(&support.condition)) plane->normal_displacement = 0;
}

}  // namespace

ElasticityProblem of_case(const ElasticityProblem& problem, const LoadCase& load_case) {
  std::set<std::string> loads, supports;
  for (const SurfaceLoad& load : problem.surface_loads) loads.insert(load.name);
  for (const VolumeLoad& load : problem.volume_loads) loads.insert(load.name);
  for (const TemperatureLoad& load : problem.temperatures) loads.insert(load.name);
  for (const PointLoad& load : problem.point_loads) loads.insert(load.name);
  for (const Support& support : problem.supports) supports.insert(support.name);
  require_known(load_case.loads, loads, load_case, "load");
  require_known(load_case.moving_supports, supports, load_case, "support");
  ElasticityProblem result = problem;
  const auto is_absent = [&](const auto& load) { return !is_among(load.name, load_case.loads); };
  std::erase_if(result.surface_loads, is_absent);
  std::erase_if(result.volume_loads, is_absent);
  std::erase_if(result.temperatures, is_absent);
  std::erase_if(result.point_loads, is_absent);
  for (Support& support : result.supports)
    if (!is_among(support.name, load_case.moving_supports)) hold_still(support);
  return result;
}

void validate(const LoadCases& cases) {
  if (cases.cases.empty()) throw Error(ErrorCode::invalid_argument, "there is no load case");
  std::set<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!names.insert(name).second)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("two load cases or combinations have the name '{}'", name));
  };
  for (const LoadCase& one : cases.cases) add(one.name);
  for (const LoadCombination& sum : cases.combinations) {
    add(sum.name);
    if (sum.factors.size() != cases.cases.size())
      throw Error(ErrorCode::invalid_argument, fmt::format("combination '{}' has {} factors for {} cases",
                                                           sum.name, sum.factors.size(), cases.cases.size()));
    for (const double factor : sum.factors)
      if (!std::isfinite(factor))
        throw Error(
            ErrorCode::invalid_argument,
            fmt::format("combination '{}' has the factor {}; it must be a finite number", sum.name, factor));
  }
}

}  // namespace isopatch::iga
