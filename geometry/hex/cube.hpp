#pragma once

#include <array>

#include "geometry/patch_face.hpp"

namespace isopatch::geometry {

// Corner i + 2 j + 4 k of the unit cube is (i, j, k). Edge 4 d + a + 2 b runs along direction d; of the two
// other directions, increasing, the first is at its end a, the second at b. Sides are those of a patch.

/// The two directions other than d, increasing.
constexpr std::array<int, 2> other_directions(int d) {
  return d == 0 ? std::array{1, 2} : d == 1 ? std::array{0, 2} : std::array{0, 1};
}

constexpr int edge_direction(int edge) {
  return edge / 4;
}

/// The corners of an edge at the low and the high end of its direction.
constexpr std::array<int, 2> edge_corners(int edge) {
  const int d = edge_direction(edge);
  const auto others = other_directions(d);
  const int low = ((edge & 1) << others[0]) | (((edge >> 1) & 1) << others[1]);
  return {low, low | (1 << d)};
}

/// The corner of a side where its two tangent directions are at the ends s and t.
constexpr int side_corner(Side side, int s, int t) {
  const auto along = tangents(side);
  return (static_cast<int>(is_high(side)) << direction(side)) | (s << along[0]) | (t << along[1]);
}

/// The edges that bound a side, t = 0 and t = 1 (along s), s = 0 and s = 1
/// (along t).
constexpr std::array<int, 4> side_edges(Side side) {
  const auto along = tangents(side);
  const int across = direction(side);
  const int high = is_high(side) ? 1 : 0;
  std::array<int, 4> result{};
  for (int k = 0; k < 4; ++k) {
    const int d = along[static_cast<std::size_t>(k / 2)];
    const auto others = other_directions(d);
    int ends = 0;
    for (int i = 0; i < 2; ++i) {
      const int end = others[static_cast<std::size_t>(i)] == across ? high : (k & 1);
      ends |= end << i;
    }
    result[static_cast<std::size_t>(k)] = 4 * d + ends;
  }
  return result;
}

}  // namespace isopatch::geometry
