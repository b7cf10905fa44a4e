#include "app/study/model_units.hpp"

#include <fmt/format.h>

#include <variant>

namespace isopatch::app {

double ModelUnits::length(const ConfigValue& value, const std::string& what) const {
  if (!std::holds_alternative<std::string>(value.value)) return read_quantity(value, what, dimensions::none);
  return read_quantity(value, what, dimensions::length) / length_unit;
}

Eigen::Vector3d ModelUnits::point(const ConfigValue& value, const std::string& what) const {
  const auto& items = read_array(value, what);
  if (items.size() != 3)
    throw error_at(value.place, fmt::format("{}: expected 3 lengths, got {}", what, items.size()));
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i) result[i] = length(items[static_cast<std::size_t>(i)], what);
  return result;
}

std::string format_default(const Eigen::Vector3d& value) {
  return fmt::format("[{}, {}, {}]", value[0], value[1], value[2]);
}

}  // namespace isopatch::app
