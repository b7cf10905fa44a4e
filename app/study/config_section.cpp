#include "app/study/config_section.hpp"

#include <fmt/format.h>

#include <variant>

#include "app/study/keys.hpp"

namespace isopatch::app {

ConfigSection section(const std::optional<ConfigValue>& value, const std::string& name,
                      const std::string& source) {
  if (!value) return {{}, {source, 0, 0}};
  return {read_subtable(*value, name), value->place};
}

std::vector<ConfigSection> sections(const std::optional<ConfigValue>& value, const std::string& name) {
  if (!value) return {};
  const auto* items = std::get_if<std::vector<ConfigValue>>(&value->value);
  if (!items)
    throw error_at(value->place,
                   fmt::format("{}: write [[{}]] with two brackets, as there may be several", name, name));
  std::vector<ConfigSection> result;
  for (const ConfigValue& item : *items) result.push_back({read_subtable(item, name), item.place});
  return result;
}

}  // namespace isopatch::app
