#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/config_value.hpp"

namespace isopatch::app {

/// A table of the study file and where it begins.
struct ConfigSection {
  ConfigTable table;
  Place place;
};

/// The table [name], or an empty one.
/// @param source  of the study, the place of a table that is not there
/// @throws Error invalid_argument for a value that is no table
ConfigSection section(const std::optional<ConfigValue>& value, const std::string& name,
                      const std::string& source);

/// The tables of [[name]], in the order of the file.
/// @throws Error invalid_argument for anything else, saying how it is written
std::vector<ConfigSection> sections(const std::optional<ConfigValue>& value, const std::string& name);

}  // namespace isopatch::app
