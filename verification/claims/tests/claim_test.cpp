#include "verification/claims/expect.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace isopatch::verification {
namespace {

TEST(Claim, HoldsUpToWhatIsAllowed) {
  const Claim claim{.what = "x", .reference = 2, .value = 2.02, .allowed = {0.011, "rounded"}};
  EXPECT_NEAR(difference(claim), 0.01, 1e-12);
  EXPECT_TRUE(is_within(claim));
  Claim strict = claim;
  strict.allowed = 0.009;
  EXPECT_FALSE(is_within(strict));
  EXPECT_NONFATAL_FAILURE(expect(strict), "differs by 0.01");
}

TEST(Claim, OfZeroIsAbsolute) {
  EXPECT_EQ(difference({.what = "x", .reference = 0, .value = -1e-3}), 1e-3);
}

TEST(Claim, AbsoluteCountsInTheValuesUnit) {
  Claim claim{
      .what = "x", .reference = 200, .value = 200.5, .allowed = 0.6, .comparison = Comparison::absolute};
  EXPECT_EQ(difference(claim), 0.5);
  EXPECT_TRUE(is_within(claim));
  claim.allowed = 0.4;
  EXPECT_FALSE(is_within(claim));
}

// One of each kind that holds.
std::vector<Claim> one_of_each() {
  return {
      {.what = "relative", .reference = 2, .value = 2, .allowed = 1e-3},
      {.what = "of zero", .reference = 0, .value = 0, .allowed = 1e-3},
      {.what = "exactly", .reference = 24, .value = 24},
      {.what = "absolute", .reference = 2, .value = 2, .allowed = 1e-3, .comparison = Comparison::absolute},
      {.what = "at most", .reference = 2, .value = 1, .comparison = Comparison::at_most, .least = 1},
      {.what = "at most 0", .reference = 0, .value = -1, .comparison = Comparison::at_most, .least = -1},
      {.what = "at least", .reference = 2, .value = 3, .comparison = Comparison::at_least},
      {.what = "at least 0", .reference = 0, .value = 3, .comparison = Comparison::at_least}};
}

TEST(Claim, OfNoKindHoldsForWhatIsNoNumber) {
  for (const Claim& claim : one_of_each()) {
    EXPECT_TRUE(is_within(claim)) << claim.what;
    for (const char* part : {"value", "reference", "allowed"}) {
      Claim broken = claim;
      (*part == 'v' ? broken.value : *part == 'r' ? broken.reference : broken.allowed.most) = std::nan("");
      EXPECT_FALSE(is_within(broken)) << claim.what;
      EXPECT_NONFATAL_FAILURE(expect(broken), claim.what);
    }
    Claim broken = claim;
    broken.value = broken.reference = std::nan("");
    EXPECT_FALSE(is_within(broken)) << claim.what;
    broken = claim;
    broken.least = std::nan("");
    EXPECT_FALSE(is_within(broken)) << claim.what;
  }
}

TEST(Claim, RefusesWhatAllowsTooMuch) {
  EXPECT_NONFATAL_FAILURE(expect(Claim{.what = "x", .reference = 2, .value = 2, .allowed = 0.11}),
                          "allows 0.11");
  EXPECT_NONFATAL_FAILURE(expect(Claim{.what = "x", .reference = 2, .value = 2, .allowed = std::nan("")}),
                          "allows");
}

TEST(Claim, NeedsAReasonForMoreThanAHundredth) {
  Claim claim{.what = "x", .reference = 2, .value = 2, .allowed = 0.011};
  EXPECT_NONFATAL_FAILURE(expect(claim), "allows 0.011; above 0.01 of the reference needs a reason");
  claim.allowed.reason = "two benchmarks print it differently";
  expect(claim);
  claim = {.what = "x", .reference = 200, .value = 200, .allowed = 3, .comparison = Comparison::absolute};
  EXPECT_NONFATAL_FAILURE(expect(claim), "allows 3; above 0.01 of the reference needs a reason");
}

TEST(Claim, RefusesLimitsThatLimitNothing) {
  const Claim most{.what = "iterations", .reference = 20, .value = 0, .comparison = Comparison::at_most};
  EXPECT_NONFATAL_FAILURE(expect(most), "at most without `least`");
  Claim twisted = most;
  twisted.least = 21;
  EXPECT_NONFATAL_FAILURE(expect(twisted), "has its least above its most");
  const Claim stray{.what = "x", .reference = 1, .value = 1, .least = 1};
  EXPECT_NONFATAL_FAILURE(expect(stray), "belongs to `at_most`");
  Claim both{.what = "x", .reference = 1, .value = 1, .comparison = Comparison::at_least, .least = 1};
  EXPECT_NONFATAL_FAILURE(expect(both), "beside a reference that is the least");
  both.least.reset();
  expect(both);
  both.allowed = 0.01;
  EXPECT_NONFATAL_FAILURE(expect(both), "limits are limits");
}

TEST(Claim, AtLeastHasNoUpperEnd) {
  Claim claim{.what = "x", .reference = 4, .value = 1e9, .comparison = Comparison::at_least};
  expect(claim);
  claim.value = 3;
  EXPECT_EQ(difference(claim), 0.25);
  EXPECT_NONFATAL_FAILURE(expect(claim), "says at least 4: differs by 0.25");
}

TEST(Claim, BetweenLimitsHoldsForWhatIsBetween) {
  Claim iterations{
      .what = "iterations", .reference = 20, .value = 12, .comparison = Comparison::at_most, .least = 1};
  EXPECT_TRUE(is_within(iterations));
  EXPECT_EQ(difference(iterations), 0);
  iterations.value = 21;
  EXPECT_NONFATAL_FAILURE(expect(iterations), "says 1 to 20: differs by 0.05");
  iterations.value = 0;
  EXPECT_FALSE(is_within(iterations)) << "none at all";
  iterations.value = 12;
  iterations.allowed = 0.05;
  EXPECT_FALSE(is_within(iterations)) << "limits are limits";
}

TEST(Tolerance, OfRoundOffIsComputedAndSaysWhy) {
  const Tolerance tolerance = round_off(1000, "two solves");
  EXPECT_EQ(tolerance.most, 16 * std::numeric_limits<double>::epsilon() * 1000);
  EXPECT_EQ(tolerance.reason,
            "round-off of two solves: unit round-off times 1000, times 16 for other machines");
}

Convergence cubic() {
  Convergence c{.what = "error", .source = "itself", .order = 3};
  for (const double h : {1.0, 0.5, 0.25, 0.125}) {
    c.sizes.push_back(h);
    c.errors.push_back(7 * h * h * h);
  }
  return c;
}

TEST(Convergence, HoldsForItsOrderAlone) {
  expect(cubic());
  EXPECT_NEAR(farthest_order(cubic()), 3, 1e-12);
  for (const double other : {2.8, 3.2}) {  // from both sides
    Convergence c = cubic();
    c.order = other;
    EXPECT_NONFATAL_FAILURE(expect(c), "order 3 where");
  }
}

TEST(Convergence, IsJudgedByItsWorstStep) {
  Convergence c = cubic();
  c.errors[3] *= 1.2;
  EXPECT_NEAR(farthest_order(c), 3 - std::log2(1.2), 1e-9);
}

TEST(Convergence, RefusesWhatWouldMeanNothing) {
  Convergence few = cubic();
  few.sizes.pop_back();
  few.errors.pop_back();
  EXPECT_NONFATAL_FAILURE(expect(few), "four levels");
  Convergence lax = cubic();
  lax.allowed = 0.5;
  EXPECT_NONFATAL_FAILURE(expect(lax), "allows too much");
  Convergence fine = cubic();
  for (double& error : fine.errors) error *= 1e-12;
  EXPECT_NONFATAL_FAILURE(expect(fine), "near round-off");
  for (const std::size_t level : {0u, 1u, 2u, 3u}) {
    Convergence broken = cubic();
    broken.errors[level] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NONFATAL_FAILURE(expect(broken), "near round-off");
  }
  Convergence all = cubic();
  for (double& error : all.errors) error = std::nan("");
  EXPECT_NONFATAL_FAILURE(expect(all), "near round-off");
  for (const bool order : {true, false}) {
    Convergence broken = cubic();
    (order ? broken.order : broken.allowed.most) = std::nan("");
    EXPECT_NONFATAL_FAILURE(expect(broken), "error");
  }
}

TEST(Convergence, HasOneOrderLessThanLevels) {
  ASSERT_EQ(orders(cubic()).size(), 3u);
  for (const double order : orders(cubic())) EXPECT_NEAR(order, 3, 1e-12);
}

}  // namespace
}  // namespace isopatch::verification
