#pragma once

#include <array>
#include <string_view>

namespace isopatch::app {

/// A prefix of the SI. Factors are in extended precision, so that "1.1 mm" becomes the double nearest to
/// 0.0011.
struct UnitPrefix {
  std::string_view symbol;
  long double factor;
};

/// All prefixes that are read; micro has three spellings, of which the first is written.
inline constexpr std::array unit_prefixes = {
    UnitPrefix{"n", 1e-9L}, UnitPrefix{"u", 1e-6L}, UnitPrefix{"\u00b5", 1e-6L}, UnitPrefix{"\u03bc", 1e-6L},
    UnitPrefix{"m", 1e-3L}, UnitPrefix{"c", 1e-2L}, UnitPrefix{"d", 1e-1L},      UnitPrefix{"k", 1e3L},
    UnitPrefix{"M", 1e6L},  UnitPrefix{"G", 1e9L},
};

/// Its factor; 1 for "", no prefix.
constexpr double prefix_factor(std::string_view symbol) {
  for (const UnitPrefix& prefix : unit_prefixes)
    if (prefix.symbol == symbol) return static_cast<double>(prefix.factor);
  return 1;
}

}  // namespace isopatch::app
