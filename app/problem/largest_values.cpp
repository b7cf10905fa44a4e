#include "app/problem/largest_values.hpp"

#include "app/base/internal/json_values.hpp"

namespace isopatch::app {

LargestValues largest_values(const std::string& summary) {
  const Json json = Json::parse(summary, nullptr, false);
  LargestValues result;
  const auto results = Json::json_pointer("/results");
  if (json.is_discarded() || !json.contains(results)) return result;
  const Json& found = json[results];
  const auto number = [&](const char* key) -> std::optional<double> {
    if (!found.contains(key) || !found[key].is_number()) return std::nullopt;
    return found[key].get<double>();
  };
  result.displacement = number("max_displacement");
  // `points_left_out` came with the search on faces.
  if (found.contains("points_left_out")) result.von_mises = number("max_von_mises");
  return result;
}

}  // namespace isopatch::app
