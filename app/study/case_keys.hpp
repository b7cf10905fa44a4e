#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/study/combination_input.hpp"
#include "app/study/config_section.hpp"
#include "app/study/keys.hpp"

namespace isopatch::app {

/// A string or an array of them: letters, digits, '_', '-' and '.', since cases are also names of folders.
std::vector<std::string> read_case_names(const ConfigValue& value);

/// The key `case` of loads and supports: a name or several.
template <class S>
Key<S> case_key(std::string meaning) {
  return custom_key<S>("case", "string, or array of strings", std::move(meaning),
                       [](S& target, const ConfigValue& value) { target.cases = read_case_names(value); });
}

const Keys<CombinationInput>& combination_keys();

/// @param index  of the table, from 0
CombinationInput read_combination(const ConfigSection& input, std::size_t index);

}  // namespace isopatch::app
