#pragma once

#include <string>
#include <string_view>

namespace isopatch::app {

/// Powers of the base units m, kg, s, rad and byte. Angles are kept apart so that degrees cannot pass for a
/// length.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  int data = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimensions {
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension area{.length = 2};
inline constexpr Dimension volume{.length = 3};
inline constexpr Dimension mass{.mass = 1};
inline constexpr Dimension angle{.angle = 1};
inline constexpr Dimension data{.data = 1};
inline constexpr Dimension force{.length = 1, .mass = 1, .time = -2};
inline constexpr Dimension pressure{.length = -1, .mass = 1, .time = -2};
inline constexpr Dimension energy{.length = 2, .mass = 1, .time = -2};
inline constexpr Dimension density{.length = -3, .mass = 1};
inline constexpr Dimension acceleration{.length = 1, .time = -2};
inline constexpr Dimension force_per_volume{.length = -2, .mass = 1, .time = -2};
}  // namespace dimensions

/// A value in SI units: m, kg, s, rad, N, Pa, J.
struct Quantity {
  double value = 0;
  Dimension dimension;
};

/// Reads a number with a unit: "20 MPa", "225 mm", "7850 kg/m^3", "9.81 m/s^2", "1 kN", "36 deg", "5 N/mm2".
///
/// Units: m g s N Pa J W t bar in ft lb lbf psi ksi Msi rad deg %, those of the SI with the prefixes n u m c
/// d k M G; B kB MB GB TB KiB MiB GiB TiB; products by a space, * or a middle dot, quotients by / (from left
/// to right), integer powers by ^ or digits right after the unit, brackets.
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
