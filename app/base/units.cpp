#include "app/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/base/unit_table.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

void raise(UnitScale& scale, int exponent) {
  scale.factor = std::pow(scale.factor, static_cast<long double>(exponent));
  scale.dimension.length *= exponent;
  scale.dimension.mass *= exponent;
  scale.dimension.time *= exponent;
  scale.dimension.angle *= exponent;
  scale.dimension.data *= exponent;
  scale.dimension.temperature *= exponent;
}

void multiply(UnitScale& scale, const UnitScale& other, int sign) {
  scale.factor = sign > 0 ? scale.factor * other.factor : scale.factor / other.factor;
  scale.dimension.length += sign * other.dimension.length;
  scale.dimension.mass += sign * other.dimension.mass;
  scale.dimension.time += sign * other.dimension.time;
  scale.dimension.angle += sign * other.dimension.angle;
  scale.dimension.data += sign * other.dimension.data;
  scale.dimension.temperature += sign * other.dimension.temperature;
}

/// Recursive descent over a product of units.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  UnitScale whole() {
    const UnitScale scale = product();
    if (!rest_.empty()) fail(fmt::format("unexpected '{}'", rest_));
    return scale;
  }

 private:
  UnitScale product() {
    UnitScale scale = factor();
    for (;;) {
      skip_blanks();
      if (rest_.empty() || rest_.front() == ')') return scale;
      const int sign = take("/") ? -1 : 1;
      if (sign > 0 && !take("*")) take("\u00b7");
      multiply(scale, factor(), sign);
    }
  }

  UnitScale factor() {
    skip_blanks();
    UnitScale scale;
    if (take("(")) {
      if (++depth_ > 16) fail("too many brackets");
      scale = product();
      if (!take(")")) fail("a bracket is not closed");
    } else if (take("1")) {
      return scale;
    } else {
      scale = unit();
    }
    raise(scale, exponent());
    return scale;
  }

  UnitScale unit() {
    const std::string_view symbol =
        rest_.substr(0, std::min(rest_.find_first_of(" */^()0123456789+-"), special()));
    if (symbol.empty())
      fail(rest_.empty() ? "a unit is missing at the end" : fmt::format("expected a unit at '{}'", rest_));
    const auto scale = find_unit(symbol);
    if (!scale) throw Error(ErrorCode::invalid_argument, unknown_unit(symbol));
    rest_.remove_prefix(symbol.size());
    return *scale;
  }

  /// Where a raised 2 or 3 or a middle dot begins.
  std::size_t special() const {
    return std::min({rest_.find("\u00b2"), rest_.find("\u00b3"), rest_.find("\u00b7"), rest_.size()});
  }

  int exponent() {
    if (take("\u00b2")) return 2;
    if (take("\u00b3")) return 3;
    const bool caret = take("^");
    int value = 1;
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (problem != std::errc{}) {
      if (caret || problem == std::errc::result_out_of_range) fail("expected a whole exponent");
      return 1;
    }
    if (value == 0 || std::abs(value) > 9) fail("expected an exponent from 1 to 9 or -1 to -9");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
  }
  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  [[noreturn]] static void fail(const std::string& message) {
    throw Error(ErrorCode::invalid_argument, message + " in the unit");
  }

  std::string_view rest_;
  int depth_ = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Quantity parse(std::string_view text, bool number_needed) {
  text = trimmed(text);
  const std::string_view whole = text;
  double number = 1;
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, problem] = std::from_chars(first, text.data() + text.size(), number);
  if (problem == std::errc::result_out_of_range)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the number in '{}' is too large or too small", text));
  if (problem != std::errc{}) {
    if (number_needed || text.empty())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("expected a number with a unit such as \"20 MPa\", got '{}'", text));
  } else {
    if (!std::isfinite(number))
      throw Error(ErrorCode::invalid_argument, fmt::format("'{}' is not a finite number", text));
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  if (text.size() > 1 && text[0] == ',' && std::isdigit(static_cast<unsigned char>(text[1])))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}' has a decimal comma; numbers are written with a point", whole));
  text = trimmed(text);
  if (text.empty()) return {number, dim::none};
  const UnitScale scale = UnitParser(text).whole();
  const double value = static_cast<double>(static_cast<long double>(number) * scale.factor);
  if (!std::isfinite(value)) throw Error(ErrorCode::invalid_argument, "the value overflows in SI units");
  return {value, scale.dimension};
}

struct KnownDimension {
  Dimension dimension;
  const char* unit;
  const char* description;
  const char* example;
};
constexpr std::array known_dimensions = {
    KnownDimension{dim::none, "", "a pure number", "0.3"},
    KnownDimension{dim::length, "m", "a length", "10 mm"},
    KnownDimension{dim::area, "m^2", "an area", "5 mm^2"},
    KnownDimension{dim::volume, "m^3", "a volume", "5 mm^3"},
    KnownDimension{dim::mass, "kg", "a mass", "2 kg"},
    KnownDimension{dim::angle, "rad", "an angle", "36 deg"},
    KnownDimension{dim::data, "B", "an amount of memory", "2 GB"},
    KnownDimension{dim::force, "N", "a force", "1 kN"},
    KnownDimension{dim::pressure, "Pa", "a pressure", "20 MPa"},
    KnownDimension{dim::energy, "J", "an energy or a moment", "2 J"},
    KnownDimension{dim::density, "kg/m^3", "a density", "7850 kg/m^3"},
    KnownDimension{dim::acceleration, "m/s^2", "an acceleration", "9.81 m/s^2"},
    KnownDimension{dim::force_per_volume, "N/m^3", "a force per volume", "10 kN/m^3"},
    KnownDimension{dim::temperature, "K", "a difference of temperature", "50 K"},
    KnownDimension{dim::temperature_gradient, "K/m", "a gradient of temperature", "2 K/mm"},
    KnownDimension{dim::expansion, "1/K", "a thermal expansion", "12e-6 1/K"},
    KnownDimension{dim::stiffness, "N/m", "a stiffness", "10 kN/mm"},
    KnownDimension{dim::angular_velocity, "rad/s", "an angular velocity", "3000 rpm"},
};

const KnownDimension* find(const Dimension& dimension) {
  for (const KnownDimension& known : known_dimensions)
    if (known.dimension == dimension) return &known;
  return nullptr;
}

}  // namespace

Quantity parse_quantity(std::string_view text) {
  return parse(text, true);
}

Quantity parse_scale(std::string_view text) {
  return parse(text, false);
}

std::string si_unit(const Dimension& dimension) {
  if (const KnownDimension* known = find(dimension)) return known->unit;
  std::string result;
  const auto append = [&](const char* symbol, int exponent) {
    if (exponent == 0) return;
    if (!result.empty()) result += ' ';
    result += symbol;
    if (exponent != 1) result += fmt::format("^{}", exponent);
  };
  append("kg", dimension.mass);
  append("m", dimension.length);
  append("s", dimension.time);
  append("rad", dimension.angle);
  append("B", dimension.data);
  append("K", dimension.temperature);
  return result;
}

std::string describe(const Dimension& dimension) {
  if (const KnownDimension* known = find(dimension)) return known->description;
  return "a quantity in " + si_unit(dimension);
}

std::string example(const Dimension& dimension) {
  if (const KnownDimension* known = find(dimension)) return known->example;
  return "1 " + si_unit(dimension);
}

}  // namespace isopatch::app
