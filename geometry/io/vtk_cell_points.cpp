#include "geometry/io/vtk_cell_points.hpp"

#include <cstddef>

namespace isopatch::geometry {
namespace {

// Whether a point lies at the low end, between the ends or at the high end along a direction.
enum class End { low, inside, high };

End end_of(int place, int degree) {
  return place == 0 ? End::low : place == degree ? End::high : End::inside;
}

// Around a quadrilateral: low low, high low, high high, low high.
int corner(bool first, bool second) {
  return second ? (first ? 2 : 3) : (first ? 1 : 0);
}

}  // namespace

int vtk_cell_point(const std::array<int, 3>& place, const std::array<int, 3>& degree) {
  std::array<bool, 3> inside{}, high{};
  std::array<int, 3> inner{};  // points inside of an edge along each direction
  std::array<int, 3> from{};   // this one's number among them
  int directions = 0;          // in which it lies inside
  for (std::size_t d = 0; d < 3; ++d) {
    const End end = end_of(place[d], degree[d]);
    inside[d] = end == End::inside;
    high[d] = end == End::high;
    inner[d] = degree[d] - 1;
    from[d] = place[d] - 1;
    directions += inside[d];
  }
  const auto [p, q, r] = inner;
  constexpr int corners = 8;
  const int edges = corners + 4 * (p + q + r);
  if (directions == 0) return corner(high[0], high[1]) + (high[2] ? 4 : 0);
  if (directions == 1) {
    // Around the lower face, around the upper one, then upwards.
    const int ring = corners + (high[2] ? 2 * (p + q) : 0);
    if (inside[0]) return ring + (high[1] ? p + q : 0) + from[0];
    if (inside[1]) return ring + (high[0] ? p : 2 * p + q) + from[1];
    return corners + 4 * (p + q) + r * corner(high[0], high[1]) + from[2];
  }
  if (directions == 2) {
    // The two faces across each direction.
    if (!inside[0]) return edges + (high[0] ? q * r : 0) + from[1] + q * from[2];
    if (!inside[1]) return edges + 2 * q * r + (high[1] ? p * r : 0) + from[0] + p * from[2];
    return edges + 2 * (q * r + p * r) + (high[2] ? p * q : 0) + from[0] + p * from[1];
  }
  return edges + 2 * (q * r + p * r + p * q) + from[0] + p * (from[1] + q * from[2]);
}

}  // namespace isopatch::geometry
