#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/base/dimension.hpp"

namespace isopatch::app {

/// What one of a unit is in SI units; in extended precision.
struct UnitScale {
  long double factor = 1;
  Dimension dimension;
};

/// A unit by its symbol, with a prefix where it takes one: "MPa", "in". Nothing for what is none.
std::optional<UnitScale> find_unit(std::string_view symbol);

/// Why a symbol is no unit: the one that was perhaps meant, or all there are.
std::string unknown_unit(std::string_view symbol);

/// All units in a sentence: "m g s N Pa J W with the prefixes n u m c d k M G; t bar in ...; of memory B kB
/// ...".
std::string known_units();

}  // namespace isopatch::app
