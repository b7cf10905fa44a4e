#include "app/study/load_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether a support prescribes anything but zero.
bool moves(const SupportInput& support) {
  if (const auto* roller = std::get_if<Roller>(&support.condition)) return roller->normal_displacement != 0;
  const auto* held = std::get_if<HeldDisplacement>(&support.condition);
  if (!held) return false;
  for (const auto& value : held->displacement.value)
    if (value.value_or(0) != 0) return true;
  return !held->displacement.gradient.isZero(0);
}

std::vector<std::string> case_names(const Study& study) {
  std::vector<std::string> names;
  const auto add = [&](const std::vector<std::string>& cases) {
    for (const std::string& name : cases)
      if (!is_among(name, names)) names.push_back(name);
  };
  for (const AppliedLoad& load : study.loads) add(load.cases);
  for (const SupportInput& support : study.supports) add(support.cases);
  return names;
}

iga::LoadCase load_case(const Study& study, const std::string& name) {
  iga::LoadCase result{name, {}, {}};
  for (const AppliedLoad& load : study.loads)
    if (is_among(name, load.cases)) result.loads.push_back(load.name);
  for (const SupportInput& support : study.supports)
    if (support.cases.empty() || is_among(name, support.cases))
      result.moving_supports.push_back(support.name);
  return result;
}

iga::LoadCombination combination(const CombinationInput& input, const std::vector<std::string>& names) {
  iga::LoadCombination result{input.name, std::vector<double>(names.size(), 0.0)};
  for (const auto& [name, factor] : input.factors) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw error_at(input.place, fmt::format("[[combination]]: there is no load case \"{}\"{}; there are {}",
                                              name, did_you_mean(name, names), fmt::join(names, ", ")));
    result.factors[static_cast<std::size_t>(found - names.begin())] = factor;
  }
  if (std::all_of(result.factors.begin(), result.factors.end(), [](double factor) { return factor == 0; }))
    throw error_at(input.place, fmt::format("[[combination]]: \"{}\" has no factor but 0", input.name));
  return result;
}

void check(const Study& study, const std::vector<std::string>& names) {
  for (const AppliedLoad& load : study.loads)
    if (load.cases.empty())
      throw error_at(load.place,
                     fmt::format("{} is in no load case, and others are; give it a case, or several: "
                                 "case = [\"{}\"]",
                                 load.name, fmt::join(names, "\", \"")));
  for (const SupportInput& support : study.supports)
    if (!support.cases.empty() && !moves(support))
      throw error_at(support.selection.place,
                     fmt::format("{} prescribes no displacement, so it has no case: it holds in all of them",
                                 support.name));
  std::vector<std::string> taken = names;
  for (const CombinationInput& input : study.combinations) {
    if (is_among(input.name, taken))
      throw error_at(
          input.place,
          fmt::format("[[combination]]: the name \"{}\" is that of a case or of another combination",
                      input.name));
    taken.push_back(input.name);
  }
  if (study.combinations.empty()) return;
  for (const SupportInput& support : study.supports)
    if (support.cases.empty() && moves(support))
      throw error_at(
          support.selection.place,
          fmt::format("{} prescribes a displacement in every load case, so a combination would count it "
                      "once for each; say in which case it acts: case = \"{}\"",
                      support.name, names.front()));
}

}  // namespace

iga::LoadCases load_cases(const Study& study) {
  const std::vector<std::string> names = case_names(study);
  if (names.empty()) {
    if (!study.combinations.empty())
      throw error_at(study.combinations.front().place,
                     "[[combination]] needs load cases: give loads a case, such as case = \"wind\"");
    return {};
  }
  check(study, names);
  iga::LoadCases result;
  for (const std::string& name : names) result.cases.push_back(load_case(study, name));
  for (const CombinationInput& input : study.combinations)
    result.combinations.push_back(combination(input, names));
  return result;
}

}  // namespace isopatch::app
