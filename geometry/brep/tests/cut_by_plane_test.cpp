#include "geometry/brep/cut_by_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::geometry {
namespace {

int made_by_the_cut(const CutPart& part) {
  return static_cast<int>(std::count(part.origin.begin(), part.origin.end(), std::nullopt));
}

TEST(CutByPlane, GivesPartsThatKnowTheirFaces) {
  // Through the axis of a block's bore: two halves of 15 by 20 by 10 with half a bore of radius 5.
  const Brep solid = test::made_brep("drilled");
  const std::vector<CutPart> parts = cut_by_plane(solid, {0.015, 0, 0}, {1, 0, 0});
  ASSERT_EQ(parts.size(), 2U);
  for (const CutPart& part : parts) {
    EXPECT_NEAR(part.brep.volume(), 3000e-9 - 125e-9 * std::numbers::pi, 1e-15);
    EXPECT_EQ(made_by_the_cut(part), 2);
    for (std::size_t f = 0; f < part.origin.size(); ++f) {
      const FaceId face(static_cast<int>(f));
      if (part.origin[f])
        EXPECT_EQ(part.brep.face(face).kind, solid.face(*part.origin[f]).kind);
      else
        EXPECT_NEAR(std::abs(part.brep.outward_normal(face, part.brep.domain(face).low).x()), 1, 1e-12);
    }
  }
}

TEST(CutByPlane, ExtendsAFloorThroughTheSolid) {
  // The plane of the plate's top cuts the boss off; the top itself is no cut.
  const Brep solid = test::made_brep("bored_boss");
  const std::vector<CutPart> parts = cut_by_plane(solid, {0, 0, 0.01}, {0, 0, 1});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(made_by_the_cut(parts[0]), 1);
  EXPECT_EQ(made_by_the_cut(parts[1]), 1);
}

TEST(CutByPlane, LeavesASolidThatItDoesNotMeet) {
  const Brep solid = test::made_brep("block");
  const std::vector<CutPart> parts = cut_by_plane(solid, {0, 0, 1}, {0, 0, 1});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(made_by_the_cut(parts[0]), 0);
}

}  // namespace
}  // namespace isopatch::geometry
