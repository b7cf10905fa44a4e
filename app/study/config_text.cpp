#include "app/study/config_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/base/overloaded.hpp"

namespace isopatch::app {
namespace {

/// With its length before it, so that no text can look like two.
std::string measured(const std::string& text) {
  return fmt::format("{}:{}", text.size(), text);
}

std::string text_of(const ConfigValue& value) {
  return std::visit(Overloaded{[](bool flag) { return std::string(flag ? "true" : "false"); },
                               [](std::int64_t number) { return fmt::format("i{}", number); },
                               [](double number) { return fmt::format("d{}", number); },
                               [](const std::string& text) { return measured(text); },
                               [](const std::vector<ConfigValue>& items) {
                                 std::string text = "[";
                                 for (const ConfigValue& item : items) text += text_of(item) + ",";
                                 return text + "]";
                               },
                               [](const ConfigTable& table) { return config_text(table); }},
                    value.value);
}

}  // namespace

std::string config_text(const ConfigTable& table, const std::vector<std::string>& without) {
  std::map<std::string, std::string> entries;
  for (const ConfigEntry& entry : table.entries)
    if (std::find(without.begin(), without.end(), entry.name) == without.end())
      entries[entry.name] = text_of(entry.value);
  std::string text = "{";
  for (const auto& [name, value] : entries) text += measured(name) + "=" + value + ",";
  return text + "}";
}

}  // namespace isopatch::app
