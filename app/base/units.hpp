#pragma once

#include <string>
#include <string_view>

#include "app/base/dimension.hpp"

namespace isopatch::app {

/// A value in SI units: m, kg, s, rad, N, Pa, J.
struct Quantity {
  double value = 0;
  Dimension dimension;
};

/// Reads a number with a unit: "20 MPa", "225 mm", "7850 kg/m^3", "9.81 m/s^2", "1 kN", "36 deg", "5 N/mm2".
///
/// Units are those of unit_table; products by a space, * or a middle dot, quotients by / (from left to
/// right), integer powers by ^ or digits right after the unit, brackets.
///
/// @throws Error invalid_argument  saying what could not be read; also for inf, NaN and overflow
Quantity parse_quantity(std::string_view text);

/// Reads a quantity or a bare unit, which counts once: "mm" is 0.001 m.
Quantity parse_scale(std::string_view text);

/// The symbol of the SI unit: "Pa", "m/s^2", "" for pure numbers.
std::string si_unit(const Dimension& dimension);

/// For messages: "a pressure", "a length", "a pure number", "a quantity in kg^2 m".
std::string describe(const Dimension& dimension);

/// For messages: "20 MPa", "10 mm", ...
std::string example(const Dimension& dimension);

}  // namespace isopatch::app
