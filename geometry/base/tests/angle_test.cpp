#include "geometry/base/angle.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace isopatch {
namespace {

TEST(Angle, ConvertsBetweenItsUnits) {
  EXPECT_DOUBLE_EQ(Angle::degrees(180).radians(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(Angle::radians(std::numbers::pi / 6).degrees(), 30);
  EXPECT_DOUBLE_EQ(Angle::degrees(12.5).degrees(), 12.5);
  EXPECT_EQ(Angle().radians(), 0);
}

TEST(Angle, ComputesAndCompares) {
  EXPECT_DOUBLE_EQ((Angle::degrees(30) + Angle::degrees(60)).degrees(), 90);
  EXPECT_DOUBLE_EQ((Angle::degrees(30) - Angle::degrees(60)).degrees(), -30);
  EXPECT_DOUBLE_EQ((-Angle::degrees(30) * 3 / 2).degrees(), -45);
  EXPECT_LT(Angle::degrees(57), Angle::radians(1));
  EXPECT_GT(Angle::degrees(58), Angle::radians(1));
}

}  // namespace
}  // namespace isopatch
