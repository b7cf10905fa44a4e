#include "app/base/unit_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "app/base/unit_prefixes.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

struct Unit {
  std::string_view symbol;
  long double factor;
  Dimension dimension;
  std::string_view usual_prefixes;  ///< the usual ones, each a letter; a unit that has any takes all
  bool is_other_name = false;       ///< of a unit that is in the table already
};

constexpr Dimension power_dimension{.length = 2, .mass = 1, .time = -3};
constexpr long double pound = 0.45359237L;                      // kg, exact
constexpr long double pound_force = pound * 9.80665L;           // N, exact
constexpr long double psi = pound_force / (0.0254L * 0.0254L);  // Pa

constexpr std::array units = {
    Unit{"m", 1, dim::length, "muck"},
    Unit{"g", 1e-3L, dim::mass, "km"},
    Unit{"s", 1, {.time = 1}, "m"},
    Unit{"N", 1, dim::force, "kM"},
    Unit{"Pa", 1, dim::pressure, "kMG"},
    Unit{"J", 1, dim::energy, "mk"},
    Unit{"W", 1, power_dimension, "k"},
    Unit{"t", 1000, dim::mass, ""},
    Unit{"bar", 1e5L, dim::pressure, ""},
    Unit{"in", 0.0254L, dim::length, ""},
    Unit{"ft", 0.3048L, dim::length, ""},
    Unit{"inch", 0.0254L, dim::length, "", true},  // as `info` calls them
    Unit{"foot", 0.3048L, dim::length, "", true},
    Unit{"lb", pound, dim::mass, ""},
    Unit{"lbf", pound_force, dim::force, ""},
    Unit{"psi", psi, dim::pressure, ""},
    Unit{"ksi", psi * 1000, dim::pressure, ""},
    Unit{"Msi", psi * 1000000, dim::pressure, ""},
    Unit{"rad", 1, dim::angle, ""},
    Unit{"deg", 3.14159265358979323846L / 180, dim::angle, ""},
    Unit{"\u00b0", 3.14159265358979323846L / 180, dim::angle, "", true},
    Unit{"K", 1, dim::temperature, ""},
    Unit{"rpm", 3.14159265358979323846L / 30, dim::angular_velocity, ""},
    Unit{"%", 0.01L, dim::none, ""},
    Unit{"B", 1, dim::data, ""},
    Unit{"kB", 1e3L, dim::data, ""},
    Unit{"MB", 1e6L, dim::data, ""},
    Unit{"GB", 1e9L, dim::data, ""},
    Unit{"TB", 1e12L, dim::data, ""},
    Unit{"KiB", 1024, dim::data, ""},
    Unit{"MiB", 1048576, dim::data, ""},
    Unit{"GiB", 1073741824, dim::data, ""},
    Unit{"TiB", 1099511627776, dim::data, ""},
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return result;
}

/// What people write: units alone and with their usual prefixes.
std::vector<std::string> usual_names() {
  std::vector<std::string> result;
  for (const Unit& unit : units) {
    result.emplace_back(unit.symbol);
    for (const char prefix : unit.usual_prefixes) result.push_back(prefix + std::string(unit.symbol));
  }
  return result;
}

template <class Fits>
std::string listed(Fits fits) {
  std::vector<std::string_view> symbols;
  for (const Unit& unit : units)
    if (!unit.is_other_name && fits(unit)) symbols.push_back(unit.symbol);
  return fmt::format("{}", fmt::join(symbols, " "));
}

std::string listed_prefixes() {
  std::vector<std::string_view> symbols;
  for (const UnitPrefix& prefix : unit_prefixes)
    if (prefix.symbol.size() == 1) symbols.push_back(prefix.symbol);
  return fmt::format("{}", fmt::join(symbols, " "));
}

}  // namespace

std::optional<UnitScale> find_unit(std::string_view symbol) {
  for (const Unit& unit : units)
    if (unit.symbol == symbol) return UnitScale{unit.factor, unit.dimension};
  for (const UnitPrefix& prefix : unit_prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    const std::string_view rest = symbol.substr(prefix.symbol.size());
    for (const Unit& unit : units)
      if (!unit.usual_prefixes.empty() && unit.symbol == rest)
        return UnitScale{prefix.factor * unit.factor, unit.dimension};
  }
  return std::nullopt;
}

std::string unknown_unit(std::string_view symbol) {
  const std::vector<std::string> known = usual_names();
  for (const std::string& name : known)
    if (lower(name) == lower(symbol))
      return fmt::format("unknown unit '{}' (did you mean '{}'? Capitals matter)", symbol, name);
  return fmt::format("unknown unit '{}'{}; known: {}", symbol, did_you_mean(symbol, known), known_units());
}

std::string known_units() {
  return fmt::format(
      "{} with the prefixes {}; {}; of memory {}",
      listed([](const Unit& unit) { return !unit.usual_prefixes.empty(); }), listed_prefixes(),
      listed([](const Unit& unit) { return unit.usual_prefixes.empty() && unit.dimension != dim::data; }),
      listed([](const Unit& unit) { return unit.dimension == dim::data; }));
}

}  // namespace isopatch::app
