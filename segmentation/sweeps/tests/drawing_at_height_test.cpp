#include "segmentation/sweeps/internal/drawing_at_height.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {
namespace {

/// Across whose floor a pocket's drafted walls are inclined.
SweepFrame frame_of_pocket(const geometry::Brep& solid) {
  for (const SweepFrame& frame : sweep_frames(solid))
    if (std::abs(frame.along.z()) > 0.5) return frame;
  throw std::runtime_error("no frame");
}

/// A pocket with drafted walls, seen along them.
struct Pocket {
  geometry::Brep solid = geometry::test::made_brep("drafted_pocket");
  SweepFrame frame = frame_of_pocket(solid);
  SweptDrawing drawing = swept_drawing(solid, frame);
  std::array<double, 2> range = range_of(drawing.tracks);
};

double least_over_heights(const Pocket& pocket, const SweptDrawing& drawing, const Quadrangulation& quads) {
  const ProfilesAtHeights there = profiles_at_heights(pocket.solid, pocket.frame, drawing);
  return standing_quads(pocket.solid, pocket.frame, drawing, there, quads).least_jacobian;
}

double to_nearest(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& to) {
  double result = (points.front() - to).norm();
  for (const Eigen::Vector2d& point : points)
    if (!((point - to).norm() >= result)) result = (point - to).norm();
  return result;
}

TEST(DrawingAtHeight, HasInclinedWallsWhereTheyAreThere) {
  const Pocket pocket;
  EXPECT_LT(pocket.range[0], pocket.range[1]);
  for (const double height : pocket.range) {
    const Profile profile = profile_at(pocket.solid, pocket.frame, pocket.drawing, height);
    for (const auto vertex : pocket.solid.vertices().colwise()) {
      const Eigen::Vector3d corner = vertex;
      if (std::abs(pocket.frame.height(corner) - height) > 1e-9 * pocket.solid.size()) continue;
      EXPECT_LT(to_nearest(profile.vertices, pocket.frame.flat(corner)), 1e-9 * pocket.solid.size());
    }
    for (const ProfileEdge& edge : profile.edges) {
      if (edge.start < 0) continue;
      EXPECT_EQ(edge.points.front(), profile.vertices[static_cast<std::size_t>(edge.start)]);
      EXPECT_EQ(edge.points.back(), profile.vertices[static_cast<std::size_t>(edge.end)]);
    }
  }
}

TEST(DrawingAtHeight, QuadrilateralsFromHalfWayUpAreGoodAtAllHeights) {
  const Pocket pocket;
  const double half_way = (pocket.range[0] + pocket.range[1]) / 2;
  const Profile there = profile_at(pocket.solid, pocket.frame, pocket.drawing, half_way);
  const Quadrangulation quads =
      as_drawn(pocket.solid, pocket.frame, pocket.drawing, quadrangulate(there), half_way);
  for (std::size_t v = 0; v < pocket.drawing.profile.vertices.size(); ++v)
    EXPECT_EQ(quads.vertices[v], pocket.drawing.profile.vertices[v]);
  EXPECT_GT(least_over_heights(pocket, pocket.drawing, quads), 0.4);
}

TEST(DrawingAtHeight, QuadrilateralsThatFoldHigherUpAreSeen) {
  const Pocket pocket;
  Quadrangulation quads = quadrangulate(pocket.drawing.profile);
  const double sound = least_over_heights(pocket, pocket.drawing, quads);
  // A track that leads across the drawing at the top alone.
  SweptDrawing folded = pocket.drawing;
  ASSERT_FALSE(folded.tracks.vertices.empty());
  folded.tracks.vertices.front().at.back().second += Eigen::Vector2d(1, 1) * pocket.solid.size();
  EXPECT_GT(sound, 0.2);
  EXPECT_LT(least_over_heights(pocket, folded, quads), 0);
}

// A block of two levels with a pocket: the pocket's floor has one hexahedron below it, all around it two.
TEST(DrawingAtHeight, HexahedraAreCountedByTheirColumns) {
  const Pocket pocket;
  const Quadrangulation quads = quadrangulate(pocket.drawing.profile);
  const ProfilesAtHeights there = profiles_at_heights(pocket.solid, pocket.frame, pocket.drawing);
  EXPECT_TRUE(std::is_sorted(there.heights.begin(), there.heights.end()));
  int expected = 0;
  for (const Quad& quad : quads.quads) {
    const std::vector<Slab>& slabs = pocket.drawing.slabs[static_cast<std::size_t>(quad.region)];
    ASSERT_EQ(slabs.size(), 1U);
    const bool is_floor = slabs.front().high < pocket.range[1] - 1e-9;
    expected += is_floor ? 1 : 2;
  }
  const StandingQuads stands = standing_quads(pocket.solid, pocket.frame, pocket.drawing, there, quads);
  EXPECT_EQ(stands.hexahedra, expected);
  // Drafted walls lean, and nothing is more than upright.
  const auto leans = [](double cosine) { return cosine < 0.999; };
  EXPECT_TRUE(std::any_of(stands.upright.begin(), stands.upright.end(), leans));
  for (const double cosine : stands.upright) EXPECT_LE(cosine, 1 + 1e-12);
}

}  // namespace
}  // namespace isopatch::segmentation
