#include "app/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

// Factors are kept in extended precision, so that "1.1 mm" becomes the double nearest to 0.0011.
struct Unit {
  std::string_view symbol;
  long double factor;
  Dimension dimension;
  bool takes_prefix;
};

constexpr Dimension power_dimension{.length = 2, .mass = 1, .time = -3};
constexpr long double pound = 0.45359237L;                      // kg, exact
constexpr long double pound_force = pound * 9.80665L;           // N, exact
constexpr long double psi = pound_force / (0.0254L * 0.0254L);  // Pa

constexpr std::array units = {
    Unit{"m", 1, dim::length, true},
    Unit{"g", 1e-3L, dim::mass, true},
    Unit{"s", 1, {.time = 1}, true},
    Unit{"N", 1, dim::force, true},
    Unit{"Pa", 1, dim::pressure, true},
    Unit{"J", 1, dim::energy, true},
    Unit{"W", 1, power_dimension, true},
    Unit{"t", 1000, dim::mass, false},
    Unit{"bar", 1e5L, dim::pressure, false},
    Unit{"in", 0.0254L, dim::length, false},
    Unit{"ft", 0.3048L, dim::length, false},
    Unit{"inch", 0.0254L, dim::length, false},  // as `info` calls them
    Unit{"foot", 0.3048L, dim::length, false},
    Unit{"lb", pound, dim::mass, false},
    Unit{"lbf", pound_force, dim::force, false},
    Unit{"psi", psi, dim::pressure, false},
    Unit{"ksi", psi * 1000, dim::pressure, false},
    Unit{"Msi", psi * 1000000, dim::pressure, false},
    Unit{"rad", 1, dim::angle, false},
    Unit{"deg", 3.14159265358979323846L / 180, dim::angle, false},
    Unit{"\u00b0", 3.14159265358979323846L / 180, dim::angle, false},
    Unit{"%", 0.01L, dim::none, false},
    Unit{"B", 1, dim::data, false},
    Unit{"kB", 1e3L, dim::data, false},
    Unit{"MB", 1e6L, dim::data, false},
    Unit{"GB", 1e9L, dim::data, false},
    Unit{"TB", 1e12L, dim::data, false},
    Unit{"KiB", 1024, dim::data, false},
    Unit{"MiB", 1048576, dim::data, false},
    Unit{"GiB", 1073741824, dim::data, false},
    Unit{"TiB", 1099511627776, dim::data, false},
};

struct ReadPrefix {
  std::string_view symbol;
  long double factor;
};
constexpr std::array read_prefixes = {
    ReadPrefix{"n", 1e-9L}, ReadPrefix{"u", 1e-6L}, ReadPrefix{"\u00b5", 1e-6L}, ReadPrefix{"\u03bc", 1e-6L},
    ReadPrefix{"m", 1e-3L}, ReadPrefix{"c", 1e-2L}, ReadPrefix{"d", 1e-1L},      ReadPrefix{"k", 1e3L},
    ReadPrefix{"M", 1e6L},  ReadPrefix{"G", 1e9L},
};

struct UnitScale {
  long double factor = 1;
  Dimension dimension;
};

std::optional<UnitScale> find_unit(std::string_view symbol) {
  for (const Unit& unit : units)
    if (unit.symbol == symbol) return UnitScale{unit.factor, unit.dimension};
  for (const ReadPrefix& prefix : read_prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    const std::string_view rest = symbol.substr(prefix.symbol.size());
    for (const Unit& unit : units)
      if (unit.takes_prefix && unit.symbol == rest)
        return UnitScale{prefix.factor * unit.factor, unit.dimension};
  }
  return std::nullopt;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return result;
}

std::string unknown_unit(std::string_view symbol) {
  static const std::vector<std::string> known = {
      "m",   "mm",  "um",  "cm",  "km",  "g", "kg", "mg", "t",  "s",  "ms",  "N",   "kN",  "MN",
      "Pa",  "kPa", "MPa", "GPa", "bar", "J", "mJ", "kJ", "W",  "in", "ft",  "lb",  "lbf", "psi",
      "ksi", "Msi", "rad", "deg", "%",   "B", "kB", "MB", "GB", "TB", "KiB", "MiB", "GiB", "TiB"};
  for (const std::string& name : known)
    if (lower(name) == lower(symbol))
      return fmt::format("unknown unit '{}' (did you mean '{}'? Capitals matter)", symbol, name);
  return fmt::format(
      "unknown unit '{}'{}; known: m g s N Pa J W with prefixes (mm, kN, MPa, GPa, ...), t bar in ft lb "
      "lbf "
      "psi ksi Msi deg rad %, of memory B kB MB GB TB KiB MiB GiB TiB",
      symbol, did_you_mean(symbol, known));
}

void raise(UnitScale& scale, int exponent) {
  scale.factor = std::pow(scale.factor, static_cast<long double>(exponent));
  scale.dimension.length *= exponent;
  scale.dimension.mass *= exponent;
  scale.dimension.time *= exponent;
  scale.dimension.angle *= exponent;
  scale.dimension.data *= exponent;
}

void multiply(UnitScale& scale, const UnitScale& other, int sign) {
  scale.factor = sign > 0 ? scale.factor * other.factor : scale.factor / other.factor;
  scale.dimension.length += sign * other.dimension.length;
  scale.dimension.mass += sign * other.dimension.mass;
  scale.dimension.time += sign * other.dimension.time;
  scale.dimension.angle += sign * other.dimension.angle;
  scale.dimension.data += sign * other.dimension.data;
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
