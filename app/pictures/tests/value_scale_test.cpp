#include "app/pictures/value_scale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isopatch::app {
namespace {

std::vector<std::string> texts(const ValueScale& scale) {
  std::vector<std::string> all;
  for (const Tick& tick : scale.ticks) all.push_back(tick.text);
  return all;
}

TEST(ValueScale, IsWidenedToRoundNumbersInTheUnit) {
  const ValueScale scale = round_scale({0, 338.7e6}, 1e6);
  EXPECT_THAT(texts(scale), testing::ElementsAre("0", "50", "100", "150", "200", "250", "300", "350"));
  EXPECT_DOUBLE_EQ(scale.range.high, 350e6);
  EXPECT_DOUBLE_EQ(scale.ticks.front().position, 0);
  EXPECT_DOUBLE_EQ(scale.ticks.back().position, 1);
}

TEST(ValueScale, ShowsAsManyDecimalsAsItsStepHas) {
  EXPECT_THAT(texts(round_scale({0.94, 1}, 1)),
              testing::ElementsAre("0.94", "0.95", "0.96", "0.97", "0.98", "0.99", "1.00"));
  EXPECT_THAT(texts(round_scale({-577e-6, 0.7e-6}, 1e-6)),
              testing::ElementsAre("-600", "-500", "-400", "-300", "-200", "-100", "0"));
}

TEST(ValueScale, AConstantFieldHasAScaleToo) {
  const ValueScale scale = round_scale({5, 5}, 1);
  EXPECT_LT(scale.range.low, 5);
  EXPECT_GT(scale.range.high, 5);
  EXPECT_GT(round_scale({0, 0}, 1).range.high, 0);
}

TEST(ValueScale, ARangeThatWasAskedForIsKept) {
  const ValueScale scale = exact_scale({12e6, 318e6}, 1e6);
  EXPECT_EQ(scale.range.low, 12e6);
  EXPECT_EQ(scale.range.high, 318e6);
  EXPECT_THAT(texts(scale), testing::ElementsAre("50", "100", "150", "200", "250", "300"));
  const Eigen::VectorXd values = scaled(Eigen::Vector3d(0, 165e6, 400e6), scale.range);
  EXPECT_TRUE(values.isApprox(Eigen::Vector3d(0, 0.5, 1)));
}

TEST(ValueScale, APeakOnLittleAreaDoesNotCountForTheRange) {
  // A strip of unit squares with the value 1, and a tiny one with 1000.
  Surface surface;
  surface.points.resize(3, 6);
  surface.points << 0, 1, 0, 5, 5.01, 5, 0, 0, 1, 0, 0, 0.01, 0, 0, 0, 0, 0, 0;
  surface.values.resize(6);
  surface.values << 1, 1, 1, 1000, 1000, 1000;
  surface.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(range_of_area(surface, 99.9).high, 1);
  EXPECT_EQ(range_of_area(surface, 100).high, 1000);
}

}  // namespace
}  // namespace isopatch::app
