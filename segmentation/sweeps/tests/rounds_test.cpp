#include "segmentation/sweeps/rounds.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/brep/without_faces.hpp"
#include "segmentation/sweeps/swept_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

TEST(Rounds, OfACornerAreInTheWayAndGo) {
  // Three edges that meet, radius 3: two rounds along floors and the ball between them, whichever way is up.
  const Brep solid = geometry::test::made_brep("round_corner");
  EXPECT_FALSE(swept_cells(solid));
  const Rounds rounds = rounds_in_the_way(solid, 5e-3);
  ASSERT_EQ(rounds.faces.size(), 3U);
  EXPECT_NEAR(rounds.largest_radius, 3e-3, 1e-9);
  const Brep without = geometry::without_faces(solid, rounds.faces);
  EXPECT_EQ(without.faces().size(), solid.faces().size() - 3);
  EXPECT_GT(without.volume(), solid.volume());
  // A block with one upright edge round.
  const double left = (4 - 3.14159265358979323846) / 4 * 9e-6;
  EXPECT_GT(without.volume(), 6e-6 - 31e-3 * left);
  EXPECT_LT(without.volume(), 6e-6);
  EXPECT_TRUE(swept_cells(without));
}

TEST(Rounds, AreNoneOfStacksNorLargerThanAllowedNorAmongOtherFaces) {
  EXPECT_TRUE(rounds_in_the_way(geometry::test::made_brep("round_edge"), 5e-3).faces.empty());
  EXPECT_TRUE(rounds_in_the_way(geometry::test::made_brep("round_corner"), 2e-3).faces.empty());
  EXPECT_TRUE(rounds_in_the_way(geometry::test::made_brep("torus"), 5e-3).faces.empty());
}

TEST(WithoutFaces, RefusesWhereTheOthersDoNotMeet) {
  EXPECT_ERROR(geometry::without_faces(geometry::test::made_brep("block"), {FaceId(0)}),
               ErrorCode::unsupported, "do not meet without it");
}

}  // namespace
}  // namespace isopatch::segmentation
