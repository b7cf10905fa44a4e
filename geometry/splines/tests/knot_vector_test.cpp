#include "geometry/splines/knot_vector.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/splines/tests/random_nurbs.hpp"

namespace isopatch::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal(int degree, std::vector<double> knots) {
  try {
    KnotVector(degree, std::move(knots));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "accepted";
}

TEST(KnotVector, RefusesWhatIsNoClampedSplineSpace) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(0, {0, 1}), HasSubstr("degree 0 is outside 1 .. 20"));
  EXPECT_THAT(refusal(21, std::vector<double>(44, 0.0)), HasSubstr("degree 21"));
  EXPECT_THAT(refusal(-3, {0, 1}), HasSubstr("degree -3"));
  EXPECT_THAT(refusal(2, {0, 0, 0, 1, 1}), HasSubstr("5 knots are too few for degree 2"));
  EXPECT_THAT(refusal(1, {}), HasSubstr("0 knots are too few"));
  EXPECT_THAT(refusal(1, {0, 0, nan, 1, 1}), HasSubstr("knot 2 is nan"));
  EXPECT_THAT(refusal(1, {0, 0, infinity, infinity}), HasSubstr("knot 2 is inf"));
  EXPECT_THAT(refusal(1, {0, 0, 0.5, 0.4, 1, 1}),
              HasSubstr("knot 3 (0.4) is smaller than the one before (0.5)"));
  EXPECT_THAT(refusal(1, {1, 1, 1, 1}), HasSubstr("all knots are equal"));
  EXPECT_THAT(refusal(2, {0, 0, 0.1, 1, 1, 1}), HasSubstr("not clamped"));
  EXPECT_THAT(refusal(2, {0, 0, 0, 0.9, 1, 1}), HasSubstr("not clamped"));
  EXPECT_THAT(refusal(1, {0, 0, 0, 1, 1}), HasSubstr("end knot is repeated"));
  EXPECT_THAT(refusal(1, {0, 0, 1, 1, 1}), HasSubstr("end knot is repeated"));
  EXPECT_THAT(refusal(2, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}),
              HasSubstr("repeated more than degree = 2 times"));
  EXPECT_THAT(refusal(1, {0, 0, 1e-17, 1, 1}), HasSubstr("closer than"));
  EXPECT_THAT(refusal(1, {-1e308, -1e308, 1e308, 1e308}), HasSubstr("range"));
  EXPECT_THAT(refusal(1, {0, 0, 1e-310, 1e-310}), HasSubstr("range"));
}

TEST(KnotVector, RefusesSpacesThatCannotBeMade) {
  EXPECT_ERROR(KnotVector::bezier(-5), ErrorCode::invalid_argument, "degree -5 is outside");
  EXPECT_ERROR(KnotVector::bezier(2, 1, 1), ErrorCode::invalid_argument, "all knots are equal");
  EXPECT_ERROR(KnotVector::uniform(2, 0), ErrorCode::invalid_argument, "0 elements");
  EXPECT_ERROR(KnotVector::uniform(-2, 3), ErrorCode::invalid_argument, "degree -2 is outside");
  EXPECT_ERROR(KnotVector::uniform(2, 3, 0), ErrorCode::invalid_argument, "multiplicity 0");
  EXPECT_ERROR(KnotVector::uniform(2, 3, 3), ErrorCode::invalid_argument, "multiplicity 3");
  EXPECT_ERROR(KnotVector::uniform(2, 3, -1), ErrorCode::invalid_argument, "multiplicity -1");
  EXPECT_ERROR(rescaled(KnotVector(), 1, 1), ErrorCode::invalid_argument, "empty range [1, 1]");
}

TEST(KnotVector, CountsItsBreaksAndFunctions) {
  const KnotVector knots(2, {0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1});
  EXPECT_EQ(knots.size(), 6);
  EXPECT_EQ(knots.element_count(), 3);
  EXPECT_THAT(knots.breaks(), ElementsAre(0, 0.25, 0.5, 1));
  EXPECT_THAT(knots.multiplicities(), ElementsAre(3, 1, 2, 3));
  EXPECT_THAT(knots.greville(), ElementsAre(0, 0.125, 0.375, 0.5, 0.75, 1));
  EXPECT_EQ(KnotVector::uniform(3, 4, 2).size(), 4 + 3 * 2);
}

TEST(KnotVector, FindsTheSpanThatHoldsAParameter) {
  const KnotVector knots(2, {0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1});
  EXPECT_EQ(knots.span(-1), 2);
  EXPECT_EQ(knots.span(0), 2);
  EXPECT_EQ(knots.span(0.25), 3);
  EXPECT_EQ(knots.span(std::nextafter(0.5, 0)), 3);
  EXPECT_EQ(knots.span(0.5), 5);
  EXPECT_EQ(knots.span(1), 5);
  EXPECT_EQ(knots.span(2), 5);
}

TEST(KnotVector, KeepsItsEndsWhenReversedAndRescaled) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const KnotVector knots = test::random_knots(random, 1 + trial % 6);
    const KnotVector turned = reversed(knots);
    EXPECT_EQ(turned.first(), knots.first());
    EXPECT_EQ(turned.last(), knots.last());
    EXPECT_TRUE(same_space(reversed(turned), knots, 1e-15));
    const auto forward = knots.multiplicities();
    const auto backward = turned.multiplicities();
    EXPECT_TRUE(std::equal(forward.begin(), forward.end(), backward.rbegin(), backward.rend()));
    const KnotVector moved = rescaled(knots, -0.1, 1e3 / 7);
    EXPECT_EQ(moved.first(), -0.1);
    EXPECT_EQ(moved.last(), 1e3 / 7);
    EXPECT_TRUE(same_space(moved, knots, 1e-14));
  }
}

TEST(KnotVector, TellsSpacesApart) {
  const KnotVector knots(2, {0, 0, 0, 0.5, 1, 1, 1});
  EXPECT_TRUE(same_space(knots, KnotVector(2, {2, 2, 2, 3, 4, 4, 4}), 0));
  EXPECT_FALSE(same_space(knots, KnotVector(2, {0, 0, 0, 0.5001, 1, 1, 1}), 1e-6));
  EXPECT_TRUE(same_space(knots, KnotVector(2, {0, 0, 0, 0.5001, 1, 1, 1}), 1e-3));
  EXPECT_FALSE(same_space(knots, KnotVector::bezier(2), 1));
  EXPECT_FALSE(same_space(knots, KnotVector::bezier(4), 1));
}

}  // namespace
}  // namespace isopatch::geometry
