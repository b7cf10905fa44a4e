#include "verification/claims/expect.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace isopatch::verification {
namespace {

TEST(Claim, HoldsUpToWhatIsAllowed) {
  const Claim claim{.what = "x", .reference = 2, .value = 2.02, .allowed = 0.011};
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

TEST(Claim, NeverHoldsForWhatIsNoNumber) {
  EXPECT_FALSE(is_within({.what = "x", .reference = 1, .value = std::nan(""), .allowed = 0.1}));
  EXPECT_FALSE(is_within({.what = "x", .reference = std::nan(""), .value = 1, .allowed = 0.1}));
  EXPECT_FALSE(is_within({.what = "x", .reference = 1, .value = std::nan(""), .least = 0}));
}

TEST(Claim, RefusesWhatAllowsTooMuch) {
  EXPECT_NONFATAL_FAILURE(expect(Claim{.what = "x", .reference = 2, .value = 2, .allowed = 0.11}),
                          "allows 0.11");
  EXPECT_NONFATAL_FAILURE(expect(Claim{.what = "x", .reference = 2, .value = 2, .allowed = std::nan("")}),
                          "allows");
}

TEST(Claim, BetweenLimitsHoldsForWhatIsBetween) {
  Claim iterations{.what = "iterations", .reference = 20, .value = 12, .least = 1};
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
  Convergence broken = cubic();
  broken.errors[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NONFATAL_FAILURE(expect(broken), "near round-off");
}

TEST(Convergence, HasOneOrderLessThanLevels) {
  ASSERT_EQ(orders(cubic()).size(), 3u);
  for (const double order : orders(cubic())) EXPECT_NEAR(order, 3, 1e-12);
}

}  // namespace
}  // namespace isopatch::verification
