#include "geometry/base/adaptive_integral.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isopatch {
namespace {

using Values = Eigen::Array<double, 1, 1>;

template <class Function>
IntegralEstimate<1> integral(const Function& f, double from, double to, double allowed, int most = 100000) {
  AdaptiveIntegral<1> integrate;
  return integrate([&](int, double t) { return Values(f(t)); }, {{0, from, to}},
                   [&](const Values&) { return Values(allowed); }, most);
}

TEST(AdaptiveIntegral, EachRuleIsExactForThePolynomialsOfItsDegree) {
  for (int degree = 0; degree <= 23; ++degree) {
    const auto power = [&](double t) { return std::pow(t, degree); };
    // 7 points suffice where the rule of 3 is exact too, and 15 where that of 7 is.
    const IntegralEstimate<1> found = integral(power, 0, 2, 1e-12 * std::exp2(degree), 15);
    const double exact = std::exp2(degree + 1) / (degree + 1);
    EXPECT_NEAR(found.value(0), exact, 1e-14 * exact) << degree;
    EXPECT_EQ(found.evaluations, degree <= 5 ? 7 : 15) << degree;
    if (degree <= 11)
      EXPECT_LT(found.error(0), 1e-14 * exact) << degree;
    else
      EXPECT_GT(found.error(0), 1e-14 * exact) << degree;
  }
}

TEST(AdaptiveIntegral, StretchesRunEitherWayAndAreSummed) {
  AdaptiveIntegral<2> integrate;
  const auto f = [](int curve, double t) { return Eigen::Array2d(curve, t); };
  const auto allowed = [](const Eigen::Array2d&) { return Eigen::Array2d(1e-9, 1e-9); };
  const auto found = integrate(f, {{1, 0, 2}, {3, 2, 1}}, allowed, 1000);
  EXPECT_NEAR(found.value(0), 2 - 3, 1e-14);
  EXPECT_NEAR(found.value(1), 2 - 1.5, 1e-14);
}

TEST(AdaptiveIntegral, TheErrorIsBoundedByTheEstimateAlsoAtKinksAndRoots) {
  const double pi = std::numbers::pi;
  for (const double allowed : {1e-4, 1e-8, 1e-11}) {
    const auto kink = integral([](double t) { return std::abs(t - 0.3); }, 0, 1, allowed);
    EXPECT_LE(kink.error(0), allowed);
    EXPECT_LE(std::abs(kink.value(0) - 0.29), kink.error(0) + 1e-15);
    const auto root = integral([](double t) { return std::sqrt(t); }, 0, 1, allowed);
    EXPECT_LE(root.error(0), allowed);
    EXPECT_LE(std::abs(root.value(0) - 2.0 / 3), root.error(0) + 1e-15);
    // An ellipse of 20 x 2: nearly a corner at its tips. By the arithmetic-geometric mean, 20 digits.
    const auto ellipse =
        integral([](double t) { return std::hypot(10 * std::sin(t), std::cos(t)); }, 0, 2 * pi, allowed);
    EXPECT_LE(ellipse.error(0), allowed);
    EXPECT_NEAR(ellipse.value(0), 40.639741801008957, ellipse.error(0) + 1e-13);
  }
}

TEST(AdaptiveIntegral, WhatDoesNotConvergeSaysSo) {
  const auto rough = integral([](double t) { return std::sin(1 / t); }, 1e-6, 1, 1e-12, 500);
  EXPECT_GT(rough.error(0), 1e-12);
  EXPECT_LT(rough.evaluations, 1000);
  const auto none = integral([](double) { return std::nan(""); }, 0, 1, 1e-12);
  EXPECT_FALSE(none.error(0) <= 1e-12);
}

}  // namespace
}  // namespace isopatch
