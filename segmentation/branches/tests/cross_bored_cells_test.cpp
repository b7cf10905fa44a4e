#include "segmentation/branches/cross_bored_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

struct CrossBoredSample {
  const char* name;
  std::size_t hexahedra;  ///< at most
  int bores;
  int slots = 0;
};

class CrossBoredSolids : public testing::TestWithParam<CrossBoredSample> {};

/// Where cylinders cross, CAD programs have splines in their place, to 1e-7.
constexpr double off_where_crossed = 1e-6;

TEST_P(CrossBoredSolids, FillTheSolidAndMeetSideToSide) {
  const geometry::Brep solid = geometry::test::made_brep(GetParam().name);
  const auto made = cross_bored_cells(solid);
  ASSERT_TRUE(made);
  EXPECT_LE(made->complex.cells.size(), GetParam().hexahedra);
  EXPECT_EQ(made->bores, GetParam().bores);
  EXPECT_EQ(made->slots, GetParam().slots);
  EXPECT_GT(geometry::least_quality(made->complex), 0.2);
  test::expect_sound(solid, made->complex, off_where_crossed);
}

INSTANTIATE_TEST_SUITE_P(
    Solids, CrossBoredSolids,
    testing::Values(CrossBoredSample{"port", 21, 1}, CrossBoredSample{"ports", 24, 2},
                    CrossBoredSample{"three_bores", 60, 4}, CrossBoredSample{"sunk_port", 60, 1},
                    CrossBoredSample{"blind_bore", 70, 1}, CrossBoredSample{"slotted_bar", 14, 2, 1},
                    CrossBoredSample{"slotted_wing", 9, 1, 1}, CrossBoredSample{"pocketed_wing", 21, 1, 1},
                    CrossBoredSample{"slotted_lens", 14, 1, 1}, CrossBoredSample{"bored_lens", 9, 1},
                    CrossBoredSample{"flatted_pin", 160, 1}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(CrossBoredCells, AreNoneOfSolidsWithoutBoresAcross) {
  for (const char* name : {"block", "shaft", "bossed_bar"})
    EXPECT_FALSE(cross_bored_cells(geometry::test::made_brep(name))) << name;
}

TEST(CrossBoredCells, SayWhichBoreIsWiderThanTheOneItEndsIn) {
  EXPECT_ERROR(cross_bored_cells(geometry::test::made_brep("wide_port")), ErrorCode::unsupported, "wide");
}

}  // namespace
}  // namespace isopatch::segmentation
