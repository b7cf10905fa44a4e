#pragma once

#include <array>
#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/base/ids.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The six sides of a volume patch: low and high end of direction 1, 2 and 3.
enum class Side { west, east, south, north, front, back };

inline constexpr std::array<Side, 6> all_sides = {Side::west,  Side::east,  Side::south,
                                                  Side::north, Side::front, Side::back};

constexpr int direction(Side side) {
  return static_cast<int>(side) / 2;
}
constexpr bool is_high(Side side) {
  return static_cast<int>(side) % 2 == 1;
}
constexpr Side side_of(int direction, bool high) {
  return static_cast<Side>(2 * direction + (high ? 1 : 0));
}
constexpr Side opposite(Side side) {
  return static_cast<Side>(static_cast<int>(side) ^ 1);
}
/// The two directions that run in a side, increasing.
constexpr std::array<int, 2> tangents(Side side) {
  return direction(side) == 0 ? std::array{1, 2} : direction(side) == 1 ? std::array{0, 2} : std::array{0, 1};
}

/// "west", "east", "south", "north", "front" or "back".
std::string_view name(Side side);

/// One side of one patch.
struct PatchFace {
  PatchId patch;
  Side side = Side::west;
  auto operator<=>(const PatchFace&) const = default;
};

/// The trace of a volume on a side, parametrized by the side's two tangent directions.
NurbsSurface face_surface(const NurbsVolume& volume, Side side);

/// Indices of the control points on a side, in the order of the control points of `face_surface`.
std::vector<int> face_control_points(const std::array<int, 3>& sizes, Side side);

/// The volume parameter of a face parameter.
Parameter<3> on_side(const NurbsVolume& volume, Side side, const Parameter<2>& face_parameter);

}  // namespace isopatch::geometry
