#include "segmentation/decomposition/without_tips.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::segmentation {
namespace {

using testing::HasSubstr;

// Down along z from 41, 27 long, with a radius of 6: the apex is 6 / tan(59 degrees) below 14.
TEST(WithoutTips, SayWhichTipIsFlatWhereInMillimetres) {
  const WithoutTips made = without_tips(geometry::test::made_brep("tipped_bore"));
  ASSERT_EQ(made.flats.size(), 1U);
  EXPECT_NEAR(made.flats[0].radius, 0.0015, 1e-12);
  const double apex = 0.014 - 0.006 / std::tan(59 * std::numbers::pi / 180);
  EXPECT_LT((made.flats[0].place - Eigen::Vector3d(0.03, 0.02, apex)).norm(), 1e-9);
  const std::string text = text_of(made);
  EXPECT_THAT(text, HasSubstr("1 drill tip ends in a flat: face "));
  EXPECT_THAT(text, HasSubstr(" at (30, 20, 10.39) mm in one of 1.5 mm radius; volume +"));
}

TEST(WithoutTips, SayNothingOfSolidsWithoutTips) {
  EXPECT_EQ(text_of(without_tips(geometry::test::made_brep("drilled"))), "");
}

}  // namespace
}  // namespace isopatch::segmentation
