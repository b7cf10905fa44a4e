#include "segmentation/sweeps/swept_cells.hpp"

#include <gtest/gtest.h>

#include <string>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

struct Sample {
  const char* name;
  int hexahedra;  ///< at most
};

class SweptCells : public testing::TestWithParam<Sample> {};

TEST_P(SweptCells, FillTheSolidAndMeetSideToSide) {
  const Brep solid = geometry::test::made_brep(GetParam().name);
  const auto swept = swept_cells(solid);
  ASSERT_TRUE(swept);
  EXPECT_LE(static_cast<int>(swept->complex.cells.size()), GetParam().hexahedra);
  test::expect_sound(solid, swept->complex);
}

INSTANTIATE_TEST_SUITE_P(Solids, SweptCells,
                         testing::Values(Sample{"block", 1}, Sample{"cylinder", 5}, Sample{"drilled", 4},
                                         Sample{"grooved", 7}, Sample{"notched", 7}, Sample{"pocketed", 14},
                                         Sample{"countersunk", 8}, Sample{"drafted_pocket", 14},
                                         Sample{"drafted_boss", 14}, Sample{"shaft", 29},
                                         Sample{"bored_boss", 12}, Sample{"wavy", 5},
                                         Sample{"filleted_boss", 40}, Sample{"filleted_step", 90},
                                         Sample{"filleted_pocket", 60}, Sample{"rounded_boss", 108},
                                         Sample{"rounded_plate", 176}, Sample{"eased_block", 30}),
                         [](const auto& info) { return std::string(info.param.name); });

// What a cone cuts off is no polynomial: the solid's own volume is off by 1e-8.
TEST(SweptCells, EndOnConesThatCutWallsOff) {
  const Brep solid = geometry::test::made_brep("turned_off");
  const auto swept = swept_cells(solid);
  ASSERT_TRUE(swept);
  EXPECT_LE(swept->complex.cells.size(), 10U);
  EXPECT_GT(geometry::least_quality(swept->complex), 0.4);
  test::expect_sound(solid, swept->complex, 1e-7);
}

TEST(SweptCells, AreOfEqualPartsOfASymmetricSolidWhereWallsAreInclined) {
  const Brep solid = geometry::test::made_brep("tipped_cover");
  const auto swept = swept_cells(solid);
  ASSERT_TRUE(swept);
  EXPECT_EQ(swept->quadrilaterals % 4, 0);
  EXPECT_LE(swept->complex.cells.size(), 200U);
  EXPECT_GT(geometry::least_quality(swept->complex), 0.25);
  test::expect_sound(solid, swept->complex);
}

TEST(SweptCells, AreNotPoorWhereABoreIsNearToTwoLines) {
  const Brep solid = geometry::test::made_brep("bored_beside_a_pocket");
  const auto swept = swept_cells(solid);
  ASSERT_TRUE(swept);
  EXPECT_GT(geometry::least_quality(swept->complex), 0.25);  // 0.198 by the first bounds
  test::expect_sound(solid, swept->complex);
}

TEST(SweptCells, AreNoneOfOtherSolids) {
  for (const char* name : {"sphere", "torus", "spring", "round_corner"})
    EXPECT_FALSE(swept_cells(geometry::test::made_brep(name))) << name;
}

TEST(SweptCells, SayWhereInSpaceTheirOutlinesCannotBeDivided) {
  const Brep solid = geometry::test::made_brep("cusp");
  EXPECT_ERROR(swept_cells(solid), ErrorCode::unsupported, "mm, beside face ");
  EXPECT_ERROR(swept_cells(solid), ErrorCode::unsupported, "its outlines as seen along (0, 0, 1)");
}

TEST(SweptCells, HaveNoRoomForRoundsOnBothSidesOfAnOutline) {
  EXPECT_ERROR(swept_cells(geometry::test::made_brep("rounded_boss_on_fillet")), ErrorCode::unsupported,
               "on the other side");
}

TEST(SweptCells, KnowNarrowWallsFromTheirNeighbours) {
  // Chamfers of 1e-4 and 1e-6 of the block's edge.
  for (const double e : {1e-4, 1e-6}) {
    geometry::Polyhedron chamfered;
    chamfered.vertices.resize(3, 10);
    chamfered.vertices << 0, 1, 1, 1 - e, 0, 0, 1, 1, 1 - e, 0,  //
        0, 0, 1 - e, 1, 1, 0, 0, 1 - e, 1, 1,                    //
        0, 0, 0, 0, 0, 1, 1, 1, 1, 1;
    chamfered.faces = {{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}, {0, 1, 6, 5}, {1, 2, 7, 6},
                       {2, 3, 8, 7},    {3, 4, 9, 8},    {4, 0, 5, 9}};
    const Brep block = geometry::make_brep(chamfered);
    const auto swept = swept_cells(block);
    ASSERT_TRUE(swept);
    test::expect_sound(block, swept->complex);
  }
}

}  // namespace
}  // namespace isopatch::segmentation
