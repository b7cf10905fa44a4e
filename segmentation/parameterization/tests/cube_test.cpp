#include "segmentation/parameterization/cube.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <bit>
#include <set>

namespace isopatch::segmentation {
namespace {

Eigen::Vector3i place_of(int corner) {
  return {corner & 1, (corner >> 1) & 1, (corner >> 2) & 1};
}

TEST(Cube, EdgesJoinAllPairsOfNeighbouringCornersOnce) {
  std::set<std::set<int>> pairs;
  for (int edge = 0; edge < 12; ++edge) {
    const auto [low, high] = edge_corners(edge);
    EXPECT_EQ(place_of(high) - place_of(low), Eigen::Vector3i::Unit(edge_direction(edge)));
    pairs.insert({low, high});
  }
  EXPECT_EQ(pairs.size(), 12u);
}

TEST(Cube, OtherDirectionsAreTheTwoThatAreLeft) {
  for (int d = 0; d < 3; ++d) {
    const auto [first, second] = other_directions(d);
    EXPECT_LT(first, second);
    EXPECT_EQ(d + first + second, 3);
    EXPECT_TRUE(d != first && d != second);
  }
}

TEST(Cube, CornersOfASideLieOnIt) {
  for (const Side side : geometry::all_sides) {
    const auto [first, second] = geometry::tangents(side);
    std::set<int> corners;
    for (const int s : {0, 1})
      for (const int t : {0, 1}) {
        const Eigen::Vector3i at = place_of(side_corner(side, s, t));
        EXPECT_EQ(at[geometry::direction(side)], geometry::is_high(side) ? 1 : 0);
        EXPECT_EQ(at[first], s);
        EXPECT_EQ(at[second], t);
        corners.insert(side_corner(side, s, t));
      }
    EXPECT_EQ(corners.size(), 4u);
  }
}

TEST(Cube, EdgesOfASideJoinItsCorners) {
  std::array<int, 12> uses{};
  for (const Side side : geometry::all_sides) {
    const auto edges = side_edges(side);
    EXPECT_EQ(edge_corners(edges[0]), (std::array{side_corner(side, 0, 0), side_corner(side, 1, 0)}));
    EXPECT_EQ(edge_corners(edges[1]), (std::array{side_corner(side, 0, 1), side_corner(side, 1, 1)}));
    EXPECT_EQ(edge_corners(edges[2]), (std::array{side_corner(side, 0, 0), side_corner(side, 0, 1)}));
    EXPECT_EQ(edge_corners(edges[3]), (std::array{side_corner(side, 1, 0), side_corner(side, 1, 1)}));
    for (const int edge : edges) ++uses[static_cast<std::size_t>(edge)];
  }
  EXPECT_THAT(uses, testing::Each(2)) << "each edge bounds two sides";
}

}  // namespace
}  // namespace isopatch::segmentation
