#include "segmentation/pieces/pieced_cells.hpp"

#include <gtest/gtest.h>

#include <string>

#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

struct Sample {
  const char* name;
  std::size_t pieces;  ///< and their hexahedra, at most
  std::size_t hexahedra;
};

class PiecedSolids : public testing::TestWithParam<Sample> {};

TEST_P(PiecedSolids, FillTheSolidAndMeetSideToSide) {
  const geometry::Brep solid = geometry::test::made_brep(GetParam().name);
  const auto made = pieced_cells(solid);
  ASSERT_TRUE(made);
  EXPECT_LE(made->pieces.size(), GetParam().pieces);
  EXPECT_LE(made->complex.cells.size(), GetParam().hexahedra);
  test::expect_sound(solid, made->complex);
}

// 9, 9, 18, 14 and 19 have been seen; round-off decides between divisions that cost alike.
INSTANTIATE_TEST_SUITE_P(Solids, PiecedSolids,
                         testing::Values(Sample{"angle", 2, 11}, Sample{"bent_sheet", 3, 11},
                                         Sample{"flanged_bend", 2, 24}, Sample{"fork", 3, 17},
                                         Sample{"lugs", 3, 23}),
                         [](const auto& info) { return std::string(info.param.name); });

// The rod's circle crosses the slot, and ends inside the block between them. Sides in there are integrated on
// both sides: their volumes cancel to 1e-7.
TEST(PiecedCells, EndWhatIsRoundBeforeASlotThatItCrosses) {
  const geometry::Brep solid = geometry::test::made_brep("rod_fork");
  const auto made = pieced_cells(solid);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->pieces.size(), 4U);
  EXPECT_LE(made->complex.cells.size(), 50U);
  EXPECT_GT(geometry::least_quality(made->complex), 0.3);
  test::expect_sound(solid, made->complex, 1e-7);
}

TEST(PiecedCells, AreNoneOfOtherSolids) {
  for (const char* name : {"spring"}) EXPECT_FALSE(pieced_cells(geometry::test::made_brep(name))) << name;
}

}  // namespace
}  // namespace isopatch::segmentation
