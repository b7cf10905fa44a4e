#include "app/study/config_value.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>

namespace isopatch::app {
namespace {

Place to_place(const toml::source_region& region, const std::string& source) {
  return {source, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

ConfigTable convert_table(const toml::table& table, const std::string& source);

ConfigValue convert(const toml::node& node, const std::string& source) {
  ConfigValue result{to_place(node.source(), source), false};
  if (const auto* flag = node.as_boolean()) {
    result.value = flag->get();
  } else if (const auto* integer = node.as_integer()) {
    result.value = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    result.value = number->get();
  } else if (const auto* text = node.as_string()) {
    result.value = text->get();
  } else if (const auto* array = node.as_array()) {
    std::vector<ConfigValue> items;
    for (const toml::node& item : *array) items.push_back(convert(item, source));
    result.value = std::move(items);
  } else if (const auto* table = node.as_table()) {
    result.value = convert_table(*table, source);
  } else {
    throw error_at(result.place,
                   "dates and times are not used here; write a number, a string, an array or a table");
  }
  return result;
}

ConfigTable convert_table(const toml::table& table, const std::string& source) {
  ConfigTable result;
  for (const auto& [key, node] : table)
    result.entries.push_back({std::string(key.str()), to_place(key.source(), source), convert(node, source)});
  std::stable_sort(result.entries.begin(), result.entries.end(),
                   [](const ConfigEntry& a, const ConfigEntry& b) {
                     return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
                   });
  return result;
}

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> names(1);
  for (const char c : path) {
    if (c == '.') {
      names.emplace_back();
    } else if (c != ' ') {
      names.back() += c;
    }
  }
  return names;
}

ConfigValue& step_into_table(ConfigTable& table, const std::string& name, const Place& place) {
  for (ConfigEntry& entry : table.entries)
    if (entry.name == name) return entry.value;
  table.entries.push_back({name, place, {place, ConfigTable{}}});
  return table.entries.back().value;
}

ConfigValue& step_into(ConfigValue& value, const std::string& name, const Place& place) {
  if (auto* table = std::get_if<ConfigTable>(&value.value)) return step_into_table(*table, name, place);
  auto* items = std::get_if<std::vector<ConfigValue>>(&value.value);
  if (!items)
    throw error_at(place, fmt::format("'{}' lies inside {}, which has no keys", name, describe(value)));
  std::size_t index = 0;
  const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (problem != std::errc{} || end != name.data() + name.size() || index >= items->size())
    throw error_at(
        place, fmt::format("'{}' is no index of an array of {} (they count from 0)", name, items->size()));
  return (*items)[index];
}

std::string_view line_of(std::string_view text, int number) {
  for (; number > 1; --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

// Column of the quote that begins a string which does not end on the line; 0 if there is none.
int open_quote(std::string_view line) {
  std::size_t begin = 0;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!quote && line[i] == '#') break;
    if (quote == '"' && line[i] == '\\') {
      ++i;
    } else if (line[i] == quote) {
      quote = 0;
    } else if (!quote && (line[i] == '"' || line[i] == '\'')) {
      quote = line[i];
      begin = i;
    }
  }
  return quote ? static_cast<int>(begin) + 1 : 0;
}

ConfigValue parse_value(std::string_view text, const Place& place) {
  ConfigValue result{place, std::string(text)};
  try {
    ConfigTable table = parse_toml("value = " + std::string(text), place.source);
    if (table.entries.size() == 1) result.value = std::move(table.entries.front().value.value);
  } catch (const Error&) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first != text.npos && std::string_view("[{\"'").find(text[first]) != std::string_view::npos)
      throw error_at(place,
                     "the value is no valid TOML; does the shell take its quotes away? Quote the whole: "
                     "--set 'load.0.traction=[\"20 MPa\", 0, 0]'",
                     ErrorCode::bad_format);
    // no TOML: the text itself
  }
  return result;
}

}  // namespace

std::string to_string(const Place& place) {
  if (place.line == 0) return place.source;
  if (place.column == 0) return fmt::format("{}:{}", place.source, place.line);
  return fmt::format("{}:{}:{}", place.source, place.line, place.column);
}

Error error_at(const Place& place, const std::string& message, ErrorCode code) {
  const std::string prefix = to_string(place);
  return Error(code, prefix.empty() ? message : prefix + ": " + message);
}

const ConfigEntry* ConfigTable::find(std::string_view name) const {
  for (const ConfigEntry& entry : entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

std::string describe(const ConfigValue& value) {
  struct Describe {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t number) const { return fmt::format("the number {}", number); }
    std::string operator()(double number) const { return fmt::format("the number {}", number); }
    std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", text); }
    std::string operator()(const std::vector<ConfigValue>& items) const {
      return fmt::format("an array of {}", items.size());
    }
    std::string operator()(const ConfigTable&) const { return "a table"; }
  };
  return std::visit(Describe{}, value.value);
}

ConfigTable parse_toml(std::string_view text, const std::string& source) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw error_at({source, 0, 0}, "the file is encoded as UTF-16; save it as UTF-8", ErrorCode::bad_format);
  try {
    return convert_table(toml::parse(text, source), source);
  } catch (const toml::parse_error& error) {
    const Place place = to_place(error.source(), source);
    if (const int column = open_quote(line_of(text, place.line)))
      throw error_at(
          {source, place.line, column},
          "not valid TOML: a quote is missing on this line; the string that begins here does not end",
          ErrorCode::bad_format);
    throw error_at(place, "not valid TOML: " + std::string(error.description()), ErrorCode::bad_format);
  }
}

ConfigTable with_override(ConfigTable table, std::string_view assignment) {
  const Place place{fmt::format("--set {}", assignment), 0, 0};
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw error_at(place, "expected key=value, for example --set discretization.refine=2");
  const std::vector<std::string> names = split(assignment.substr(0, equals));
  ConfigValue* target = nullptr;
  for (const std::string& name : names) {
    if (name.empty()) throw error_at(place, "a key is empty");
    target = target ? &step_into(*target, name, place) : &step_into_table(table, name, place);
  }
  *target = parse_value(assignment.substr(equals + 1), place);
  return table;
}

}  // namespace isopatch::app
