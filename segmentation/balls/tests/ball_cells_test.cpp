#include "segmentation/balls/ball_cells.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/balls/internal/ball_frame.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::test::made_brep;

class BallCellsOf : public testing::TestWithParam<std::string> {};

// Sides are within 2e-6 of the solid's size at the worst, and errors of volume mostly cancel.
TEST_P(BallCellsOf, AreSevenThatFillTheSolid) {
  const Brep solid = made_brep(GetParam());
  const auto cells = ball_cells(solid);
  ASSERT_TRUE(cells);
  EXPECT_EQ(cells->complex.cells.size(), 7U);
  test::expect_sound(solid, cells->complex, 2e-7);
}

INSTANTIATE_TEST_SUITE_P(Solids, BallCellsOf, testing::Values("sphere", "ellipsoid", "pebble"),
                         [](const auto& info) { return info.param; });

TEST(BallCells, OfAnEllipsoidHaveItsVolume) {
  const auto cells = ball_cells(made_brep("ellipsoid"));
  double volume = 0;
  for (const Brep& cell : geometry::cell_solids(made_brep("ellipsoid"), cells->complex))
    volume += cell.volume();
  EXPECT_NEAR(1e9 * volume / (4 * std::numbers::pi / 3 * 15 * 10 * 7), 1, 1e-7);
}

// The triangulation is within 1e-3 of the solid's size, 38 mm.
TEST(BallFrame, OfAnEllipsoidIsTheEllipsoid) {
  const BallFrame frame = ball_frame(made_brep("ellipsoid"));
  EXPECT_LT(frame.centre.norm(), 1e-4);
  EXPECT_NEAR(frame.radii[0], 7e-3, 2e-4);
  EXPECT_NEAR(frame.radii[1], 10e-3, 2e-4);
  EXPECT_NEAR(frame.radii[2], 15e-3, 2e-4);
  EXPECT_NEAR(std::abs(frame.axes(0, 2)), 1, 1e-6);
  EXPECT_NEAR(frame.axes.determinant(), 1, 1e-12);
}

TEST(BallCells, AreNoneOfOtherSolids) {
  for (const char* other : {"block", "cylinder", "torus", "cone", "hollow_ball"})
    EXPECT_FALSE(ball_cells(made_brep(other))) << other;
}

TEST(BallCells, RefuseAFaceThatIsNotSeenFromTheMiddle) {
  EXPECT_ERROR(ball_cells(made_brep("banana")), ErrorCode::unsupported, "cannot be seen from the middle");
}

TEST(BallCells, RefuseAFaceWithEdges) {
  EXPECT_ERROR(ball_cells(made_brep("creased")), ErrorCode::unsupported, "its face has an edge or a tip");
}

}  // namespace
}  // namespace isopatch::segmentation
