#include "app/study/keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

Error expected(const ConfigValue& value, const std::string& what, const std::string& expectation) {
  return error_at(value.place, fmt::format("{}: expected {}, got {}", what, expectation, describe(value)));
}

std::string expectation(const Dimension& dimension) {
  if (dimension == dimensions::none) return "a number";
  return fmt::format("{} such as \"{}\", or a number in {}", describe(dimension), example(dimension),
                     si_unit(dimension));
}

double read_quantity_text(const ConfigValue& value, const std::string& what, const Dimension& dimension) {
  const std::string& text = std::get<std::string>(value.value);
  Quantity quantity;
  try {
    quantity = parse_quantity(text);
  } catch (const Error& error) {
    throw error_at(value.place,
                   fmt::format("{}: expected {}, but {}", what, expectation(dimension), error.what()));
  }
  if (quantity.dimension == dimension) return quantity.value;
  const std::string given = quantity.dimension == dimensions::none
                                ? fmt::format("\"{}\" without a unit", text)
                                : fmt::format("\"{}\", which is {}", text, describe(quantity.dimension));
  throw error_at(value.place, fmt::format("{}: expected {}, got {}", what, expectation(dimension), given));
}

}  // namespace

bool Range::contains(double value) const {
  return (least_allowed ? value >= least : value > least) && (most_allowed ? value <= most : value < most);
}

std::string Range::text() const {
  const bool below = std::isfinite(least);
  const bool above = std::isfinite(most);
  if (below && above && least_allowed && most_allowed) return fmt::format("from {} to {}", least, most);
  const std::string low = below ? fmt::format("{} {}", least_allowed ? "at least" : "above", least) : "";
  const std::string high = above ? fmt::format("{} {}", most_allowed ? "at most" : "below", most) : "";
  return below && above ? low + " and " + high : low + high;
}

bool read_flag(const ConfigValue& value, const std::string& what) {
  if (const bool* flag = std::get_if<bool>(&value.value)) return *flag;
  throw expected(value, what, "true or false");
}

int read_integer(const ConfigValue& value, const std::string& what, int least, int most) {
  const auto* number = std::get_if<std::int64_t>(&value.value);
  const auto range = fmt::format("a whole number from {} to {}", least, most);
  if (!number || *number < least || *number > most) throw expected(value, what, range);
  return static_cast<int>(*number);
}

std::string read_text(const ConfigValue& value, const std::string& what) {
  if (const auto* text = std::get_if<std::string>(&value.value)) return *text;
  throw expected(value, what, "a string");
}

double read_quantity(const ConfigValue& value, const std::string& what, const Dimension& dimension,
                     const Range& range) {
  double result = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value.value)) {
    result = static_cast<double>(*integer);
  } else if (const auto* number = std::get_if<double>(&value.value)) {
    result = *number;
  } else if (std::holds_alternative<std::string>(value.value)) {
    result = read_quantity_text(value, what, dimension);
  } else {
    throw expected(value, what, expectation(dimension));
  }
  if (!std::isfinite(result))
    throw error_at(value.place, fmt::format("{} is {}; it must be finite", what, result));
  if (!range.contains(result)) {
    const std::string unit = si_unit(dimension);
    throw error_at(value.place, fmt::format("{} is {}{}{}; it must be {}", what, result,
                                            unit.empty() ? "" : " ", unit, range.text()));
  }
  return result;
}

Eigen::Vector3d read_vector(const ConfigValue& value, const std::string& what, const Dimension& dimension) {
  const auto* items = std::get_if<std::vector<ConfigValue>>(&value.value);
  if (!items || items->size() != 3)
    throw expected(value, what, "an array of 3, each " + expectation(dimension));
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i)
    result[i] = read_quantity((*items)[static_cast<std::size_t>(i)], what, dimension);
  return result;
}

Eigen::Vector3d read_direction(const ConfigValue& value, const std::string& what) {
  if (const auto* text = std::get_if<std::string>(&value.value)) {
    const bool minus = text->starts_with('-');
    const std::string axis = text->substr(minus || text->starts_with('+') ? 1 : 0);
    if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z')
      throw expected(value, what,
                     "a direction: three numbers or \"x\", \"-x\", \"y\", \"-y\", \"z\" or \"-z\"");
    return (minus ? -1.0 : 1.0) * Eigen::Vector3d::Unit(axis[0] - 'x');
  }
  const Eigen::Vector3d direction = read_vector(value, what, dimensions::none);
  if (!(direction.norm() > 0)) throw error_at(value.place, what + " is a direction; it cannot be zero");
  return direction.stableNormalized();
}

double read_length_unit(const ConfigValue& value) {
  const std::string what = "length_unit";
  const auto* text = std::get_if<std::string>(&value.value);
  if (!text) return read_quantity(value, what, dimensions::length, positive);
  Quantity quantity;
  try {
    quantity = parse_scale(*text);
  } catch (const Error& error) {
    throw error_at(value.place, fmt::format("{}: expected a length such as \"mm\" or \"225 mm\", but {}",
                                            what, error.what()));
  }
  if (quantity.dimension != dimensions::length || !(quantity.value > 0))
    throw error_at(value.place, fmt::format("{}: expected a length such as \"mm\" or \"225 mm\", got \"{}\"",
                                            what, *text));
  return quantity.value;
}

const std::vector<ConfigValue>& read_array(const ConfigValue& value, const std::string& what) {
  if (const auto* items = std::get_if<std::vector<ConfigValue>>(&value.value)) return *items;
  throw expected(value, what, "an array");
}

const ConfigTable& read_subtable(const ConfigValue& value, const std::string& what) {
  if (const auto* table = std::get_if<ConfigTable>(&value.value)) return *table;
  throw expected(value, what, "a table");
}

Error unknown_choice(const ConfigValue& value, const std::string& what, const std::string& text,
                     const std::vector<std::string>& known) {
  return error_at(value.place, fmt::format("{}: unknown value \"{}\"{}; known: {}", what, text,
                                           did_you_mean(text, known), fmt::join(known, ", ")));
}

std::string type_name(const Dimension& dimension) {
  if (dimension == dimensions::none) return "number";
  std::string description = describe(dimension);
  description.erase(0, description.find(' ') + 1);
  return fmt::format("{} ({})", description, si_unit(dimension));
}

std::string format_default(double value) {
  return fmt::format("{}", value);
}

UnknownKey unknown_key(const ConfigEntry& entry, const std::string& heading,
                       const std::vector<std::string>& known) {
  const std::string nearest = did_you_mean(entry.name, known);
  const std::string advice = nearest.empty() ? fmt::format("; known: {}", fmt::join(known, ", ")) : nearest;
  return {error_at(entry.place, fmt::format("unknown key '{}' in {}{}", entry.name, heading, advice)),
          entry.name};
}

}  // namespace isopatch::app
