#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/base/error.hpp"

namespace isopatch::app {

/// A position in a text file, for messages. Lines and columns count from 1; 0: not known.
struct Place {
  std::string source;
  int line = 0;
  int column = 0;
  bool operator==(const Place&) const = default;
};

/// "study.toml:12:3", or "study.toml" where the line is not known.
std::string to_string(const Place& place);

/// An error that begins with its place.
Error error_at(const Place& place, const std::string& message, ErrorCode code = ErrorCode::invalid_argument);

struct ConfigEntry;

/// Entries in the order of the file; names are unique.
struct ConfigTable {
  std::vector<ConfigEntry> entries;
  /// @return nullptr if there is none
  const ConfigEntry* find(std::string_view name) const;
};

/// One value of a configuration file with its place: the format's library stays behind this type.
struct ConfigValue {
  Place place;
  std::variant<bool, std::int64_t, double, std::string, std::vector<ConfigValue>, ConfigTable> value;
};

struct ConfigEntry {
  std::string name;
  Place place;  ///< of the name
  ConfigValue value;
};

/// What kind of value it is, for messages: "a string", "a table", ...
std::string describe(const ConfigValue& value);

/// Reads TOML.
/// @param source  name of the text for messages, usually the path of its file
/// @throws Error bad_format, naming source, line and column; also for keys given twice
ConfigTable parse_toml(std::string_view text, const std::string& source);

/// The table with one value replaced or added: "discretization.refine=2", "material.0.young='210 GPa'".
/// The value is TOML; what is no TOML counts as a string, so that shells need no second pair of quotes.
/// @throws Error invalid_argument if it has no '=', or walks through something that is no table or array
ConfigTable with_override(ConfigTable table, std::string_view assignment);

}  // namespace isopatch::app
