#include "app/study/case_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace isopatch::app {
namespace {

std::string case_name(const ConfigValue& value, const std::string& what) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  std::string name = read_text(value, what);
  if (name.empty() || name.front() == '.' || name.find_first_not_of(allowed) != std::string::npos)
    throw error_at(value.place,
                   fmt::format("{}: \"{}\" cannot be the name of a load case: letters, digits, _ - "
                               "and . can, with no . in front, since folders are named so too",
                               what, name));
  return name;
}

}  // namespace

std::vector<std::string> read_case_names(const ConfigValue& value) {
  if (!std::holds_alternative<std::vector<ConfigValue>>(value.value)) return {case_name(value, "case")};
  std::vector<std::string> result;
  for (const ConfigValue& item : read_array(value, "case")) {
    result.push_back(case_name(item, "case"));
    if (std::count(result.begin(), result.end(), result.back()) > 1)
      throw error_at(item.place, fmt::format("case: \"{}\" is there twice", result.back()));
  }
  if (result.empty()) throw error_at(value.place, "case: an empty array names no case");
  return result;
}

const Keys<CombinationInput>& combination_keys() {
  using C = CombinationInput;
  static const Keys<C> keys = {
      custom_key<C>("name", "string", "What results call it; different from the names of the cases.",
                    [](C& target, const ConfigValue& value) { target.name = case_name(value, "name"); })
          .with_default("\"combination_1\", ..."),
      custom_key<C>(
          "factors", "table of numbers",
          "By which the cases are multiplied before they are added: { gravity = 1.35, wind = 1.5 }; "
          "cases that are not there do not count.",
          [](C& target, const ConfigValue& value) {
            for (const ConfigEntry& entry : read_subtable(value, "factors").entries)
              target.factors.emplace_back(
                  entry.name, read_quantity(entry.value, "factors." + entry.name, dimensions::none));
          })
          .required(),
  };
  return keys;
}

CombinationInput read_combination(const ConfigSection& input, std::size_t index) {
  auto result = read_table<CombinationInput>(input.table, input.place, "[[combination]]", combination_keys());
  if (result.factors.empty()) throw error_at(input.place, "[[combination]]: factors names no case");
  if (result.name.empty()) result.name = fmt::format("combination_{}", index + 1);
  result.place = input.place;
  return result;
}

}  // namespace isopatch::app
