#include "geometry/hex/cube.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace isopatch::geometry {
namespace {

TEST(Cube, EdgesOfASideRunAlongItsFrame) {
  for (const Side side : all_sides) {
    const auto edges = side_edges(side);
    for (int k = 0; k < 4; ++k) {
      const int high = k % 2;
      const auto ends = edge_corners(edges[static_cast<std::size_t>(k)]);
      EXPECT_EQ(ends[0], k < 2 ? side_corner(side, 0, high) : side_corner(side, high, 0));
      EXPECT_EQ(ends[1], k < 2 ? side_corner(side, 1, high) : side_corner(side, high, 1));
    }
  }
}

TEST(Cube, EveryEdgeLiesOnTwoSides) {
  std::multiset<int> uses;
  for (const Side side : all_sides)
    for (const int edge : side_edges(side)) uses.insert(edge);
  for (int edge = 0; edge < 12; ++edge) EXPECT_EQ(uses.count(edge), 2u);
}

}  // namespace
}  // namespace isopatch::geometry
