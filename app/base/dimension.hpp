#pragma once

namespace isopatch::app {

/// Powers of the base units m, kg, s, rad, byte and K. Angles are kept apart so that degrees cannot pass for
/// a length.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  int data = 0;
  int temperature = 0;
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
inline constexpr Dimension temperature{.temperature = 1};
inline constexpr Dimension temperature_gradient{.length = -1, .temperature = 1};
inline constexpr Dimension expansion{.temperature = -1};
inline constexpr Dimension stiffness{.mass = 1, .time = -2};
inline constexpr Dimension angular_velocity{.time = -1, .angle = 1};
}  // namespace dimensions

}  // namespace isopatch::app
