#include "segmentation/profiles/divide_side.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/profiles/tests/division_check.hpp"
#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation {
namespace {

using namespace drawings;

/// The first edge for which something holds.
template <class Condition>
int edge_that(const Quadrangulation& quads, Condition condition) {
  const auto found = std::find_if(quads.edges.begin(), quads.edges.end(), condition);
  EXPECT_NE(found, quads.edges.end());
  return static_cast<int>(found - quads.edges.begin());
}

TEST(DivideSide, GoesOnUntilTheOutline) {
  // One quadrilateral of four around a bore has the plate's left side: from there the cut goes to the bore.
  const Profile profile = row_of_bores(1);
  const Quadrangulation quads = quadrangulate(profile);
  const int left = edge_that(quads, [](const QuadEdge& edge) { return edge.profile_edge == 3; });
  const DividedQuads made = divide_side(profile, quads, left, 0.25);
  EXPECT_EQ(made.quads.quads.size(), 5U);
  EXPECT_EQ(checks::fault_of(profile, made.quads), "");
  ASSERT_EQ(made.parent.size(), 5U);
  EXPECT_EQ(std::count(made.parent.begin(), made.parent.end(), made.parent[0]) +
                std::count(made.parent.begin(), made.parent.end(), made.parent[4]),
            made.parent[0] == made.parent[4] ? 4 : 3);
  // The new vertex is where it was asked for: the left side runs down from (0, 2).
  const bool there = std::any_of(made.quads.vertices.begin(), made.quads.vertices.end(),
                                 [](const Vector2d& v) { return (v - Vector2d(0, 1.5)).norm() < 1e-12; });
  EXPECT_TRUE(there);
}

TEST(DivideSide, RunsAroundARingAsItsSidesDo) {
  const Profile profile = ring(0.5);
  const Quadrangulation quads = quadrangulate(profile);
  const int spoke = edge_that(quads, [](const QuadEdge& edge) { return edge.profile_edge < 0; });
  const DividedQuads made = divide_side(profile, quads, spoke, 0.5);
  EXPECT_EQ(made.quads.quads.size(), 8U);
  EXPECT_EQ(checks::fault_of(profile, made.quads), "");
  const checks::Shapes shapes(profile, made.quads);
  int parabolas = 0;
  for (std::size_t e = 0; e < made.quads.edges.size(); ++e) {
    if (!made.quads.edges[e].apex) continue;
    ++parabolas;
    EXPECT_NEAR(shapes.at({EdgeId(static_cast<int>(e)), false}, 0.5).norm(), 0.75, 1e-6);
  }
  EXPECT_EQ(parabolas, 4);
  // Once more, through the parabolas.
  const int parabola = edge_that(made.quads, [](const QuadEdge& edge) { return edge.apex.has_value(); });
  const DividedQuads again = divide_side(profile, made.quads, parabola, 0.3);
  EXPECT_EQ(again.quads.quads.size(), 10U);
  EXPECT_EQ(checks::fault_of(profile, again.quads), "");
}

TEST(DivideSide, KeepsRandomDrawingsSound) {
  const Profile profile = row_of_bores(3);
  Quadrangulation quads = quadrangulate(profile);
  for (int round = 0; round < 6; ++round) {
    const int edge = static_cast<int>((17U * static_cast<unsigned>(round) + 3) % quads.edges.size());
    quads = divide_side(profile, quads, edge, 0.4).quads;
    EXPECT_EQ(checks::fault_of_edges(quads), "");
    EXPECT_EQ(checks::fault_of_outline(profile, quads), "");
  }
}

}  // namespace
}  // namespace isopatch::segmentation
