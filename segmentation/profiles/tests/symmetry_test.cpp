#include "segmentation/profiles/symmetry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/profiles/tests/division_check.hpp"

namespace isopatch::segmentation {
namespace {

using Eigen::Vector2d;

ProfileEdge straight(const Profile& profile, int start, int end) {
  return {start, end, {profile.vertices[start], profile.vertices[end]}};
}

ProfileEdge half_circle(const Profile& profile, int start, int end) {
  const Vector2d a = profile.vertices[start], b = profile.vertices[end], centre = (a + b) / 2, x = a - centre;
  ProfileEdge edge{start, end, {}};
  for (int i = 0; i <= 24; ++i) {
    const double angle = std::numbers::pi * i / 24;
    edge.points.push_back(centre + std::cos(angle) * x + std::sin(angle) * Vector2d(-x.y(), x.x()));
  }
  return edge;
}

/// A rectangle of 4 x 2 with a bore of radius 1 / 2 in its middle, divided along y = 0.
Profile bored(double corner = 1) {
  Profile result;
  result.vertices = {{-2, 0}, {-2, -1}, {2, -1}, {2, 0}, {2, corner}, {-2, 1}, {-0.5, 0}, {0.5, 0}};
  for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {0, 6}, {7, 3}})
    result.edges.push_back(straight(result, a, b));
  result.edges.push_back(half_circle(result, 7, 6));
  result.edges.push_back(half_circle(result, 6, 7));
  const auto use = [](int edge, bool reversed = false) { return geometry::EdgeUse{EdgeId(edge), reversed}; };
  result.regions = {{{{use(0), use(1), use(2), use(7, true), use(9, true), use(6, true)}}},
                    {{{use(3), use(4), use(5), use(6), use(8, true), use(7)}}}};
  return result;
}

TEST(MirrorLines, AreOfSoundProfilesOnly) {
  EXPECT_ERROR(mirror_lines(bored(std::nan(""))), ErrorCode::bad_format, "not finite");
}

TEST(MirrorLines, AreFoundAlongBothAxes) {
  const std::vector<MirrorLine> lines = mirror_lines(bored());
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(std::abs(lines[0].along.x()), 1, 1e-15);
  EXPECT_NEAR(lines[0].point.norm(), 0, 1e-12);
  EXPECT_NEAR(lines[0].along.dot(lines[1].along), 0, 1e-15);
}

TEST(MirrorLines, AreNoneWhereACornerIsSlightlyOff) {
  EXPECT_TRUE(mirror_lines(bored(1 + 1e-5)).empty());
}

TEST(MirroredQuadrangulation, FillsTheDrawingAndIsSymmetric) {
  const Profile profile = bored();
  const Quadrangulation quads = mirrored_quadrangulation(profile, {{{0, 0}, {1, 0}}});
  EXPECT_EQ(checks::fault_of(profile, quads), "");
  EXPECT_EQ(quads.quads.size() % 2, 0U);
  for (const Vector2d& vertex : quads.vertices)
    EXPECT_TRUE(std::any_of(quads.vertices.begin(), quads.vertices.end(), [&](const Vector2d& other) {
      return (other - Vector2d(vertex.x(), -vertex.y())).norm() < 1e-6;
    }));
}

/// A square in its eight parts between its four lines of symmetry.
Profile square_in_eight() {
  Profile result;
  result.vertices = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {0, 0}};
  for (int i = 0; i < 8; ++i) result.edges.push_back(straight(result, i, (i + 1) % 8));
  for (int i = 0; i < 8; ++i) result.edges.push_back(straight(result, 8, i));
  for (int i = 0; i < 8; ++i)
    result.regions.push_back(
        {{{{EdgeId(8 + i), false}, {EdgeId(i), false}, {EdgeId(8 + (i + 1) % 8), true}}}});
  return result;
}

TEST(MirroredQuadrangulation, PutsAWedgeTogetherAllAround) {
  const Profile profile = square_in_eight();
  const auto ways = ways_to_mirror(mirror_lines(profile));
  ASSERT_EQ(ways.size(), 4U);  // a wedge, a quarter, two halves
  ASSERT_EQ(ways[0].size(), 2U);
  EXPECT_NEAR(std::abs(ways[0][0].along.dot(ways[0][1].along)), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(all_images(ways[0]).size(), 4U);
  const Quadrangulation quads = mirrored_quadrangulation(profile, ways[0]);
  EXPECT_EQ(checks::fault_of(profile, quads), "");
  EXPECT_EQ(quads.quads.size(), 8 * 3U);
  EXPECT_EQ(quads.vertices.size(), 9 + 16 + 8U);  // given ones, middles of sides, one inside each part
}

TEST(MirroredQuadrangulation, HasChordsForLinesThatBoundNothing) {
  const Profile profile = square_in_eight();
  const auto wedge = ways_to_mirror(mirror_lines(profile)).front();
  const Quadrangulation quads = without_lines(profile, wedge, mirrored_quadrangulation(profile, wedge));
  for (const QuadEdge& edge : quads.edges) EXPECT_LT(edge.profile_edge, 8);
  EXPECT_EQ(std::count_if(quads.edges.begin(), quads.edges.end(),
                          [](const QuadEdge& edge) { return edge.profile_edge >= 0; }),
            16);
}

TEST(MirroredQuadrangulation, NeedsLinesAtAWholePartOf180Degrees) {
  const double angle = 1;
  EXPECT_ERROR(all_images({{{0, 0}, {1, 0}}, {{0, 0}, {std::cos(angle), std::sin(angle)}}}),
               ErrorCode::unsupported, "whole part of 180 degrees");
}

TEST(MirroredQuadrangulation, NeedsEdgesAlongTheLine) {
  EXPECT_ERROR(mirrored_quadrangulation(bored(), {{{0, 0}, {0, 1}}}), ErrorCode::unsupported,
               "not divided along its line of symmetry");
}

}  // namespace
}  // namespace isopatch::segmentation
