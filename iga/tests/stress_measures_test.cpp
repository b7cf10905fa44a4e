#include "iga/post/stress_measures.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "geometry/base/larger.hpp"
#include "iga/post/stress_peaks.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {
namespace {

Eigen::Matrix3d rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

TEST(PrincipalStresses, AreThoseThatWereTurned) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d axes = rotation(random);
    const Eigen::Vector3d values(5e6, 1e6, -7e6);
    const PrincipalStresses found = principal_stresses(axes * values.asDiagonal() * axes.transpose());
    EXPECT_LE((found.values - values).norm(), 1e-7);  // of 1e7
    // Directions have a sign of their own.
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(found.directions.col(k).dot(axes.col(k))), 1, 1e-12);
    EXPECT_NEAR(found.directions.determinant(), 1, 1e-12);
  }
}

// Against those with axes, by QR iterations; rounding the matrix alone changes them by 1e-16 of the largest.
TEST(PrincipalValues, KeepAllDigitsWhereTwoOrThreeAreNearlyEqual) {
  std::mt19937 random(5);
  for (const double gap : {1.0, 1e-3, 1e-8, 1e-15, 0.0})
    for (const double third : {-3.0, 0.0, 1.0, 1 + gap, 1 + 1e-12}) {
      const Eigen::Matrix3d axes = rotation(random);
      Eigen::Matrix3d stress = axes * Eigen::Vector3d(1, 1 + gap, third).asDiagonal() * axes.transpose();
      stress = (1e8 * 0.5 * (stress + stress.transpose())).eval();
      const Eigen::Vector3d found = principal_values(stress), expected = principal_stresses(stress).values;
      EXPECT_LT((found - expected).norm(), 4e-15 * 3e8) << gap << " " << third;
    }
  EXPECT_EQ(principal_values(Eigen::Matrix3d::Zero()), Eigen::Vector3d::Zero());
  EXPECT_TRUE(principal_values(Eigen::Matrix3d::Constant(std::nan(""))).array().isNaN().all());
}

// By hand: tension, pure shear, hydrostatic pressure.
TEST(StressMeasures, OfSimpleStates) {
  Eigen::Matrix3d tension = Eigen::Matrix3d::Zero(), shear = Eigen::Matrix3d::Zero();
  tension(1, 1) = 3e6;
  shear(0, 2) = shear(2, 0) = 2e6;
  EXPECT_DOUBLE_EQ(tresca(tension), 3e6);
  EXPECT_DOUBLE_EQ(tresca(shear), 4e6);
  EXPECT_NEAR(von_mises(shear), std::sqrt(3) * 2e6, 1e-6);
  EXPECT_EQ(tresca(-5e6 * Eigen::Matrix3d::Identity()), 0);
  EXPECT_DOUBLE_EQ(safety_factor(100e6, 235e6), 2.35);
  EXPECT_EQ(safety_factor(0, 235e6), std::numeric_limits<double>::infinity());
}

// The bounds that spare eigenvalues never hide a new peak.
TEST(StressPeaks, AreTheLargestOfAllPoints) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 10; ++round) {
    StressPeaks peaks, seen;
    Eigen::Vector4d expected = Eigen::Vector4d::Constant(-1e300);
    const double shift = 3 * uniform(random);  // all in tension, all in compression, both
    for (int i = 0; i < 200; ++i) {
      const Eigen::Matrix3d axes = rotation(random);
      const Eigen::Vector3d values(shift + uniform(random), shift + uniform(random), shift + uniform(random));
      const Eigen::Matrix3d stress = axes * values.asDiagonal() * axes.transpose();
      const double yield = i % 3 == 0 ? 0 : 1 + 0.5 * uniform(random);
      const auto here = [&]() -> Extremum { return {0, Eigen::Vector3d::Unit(0) * i, 0, {}}; };
      take(StressPoint{stress, von_mises(stress), yield}, here, seen, peaks);
      const Eigen::Vector4d of_point(
          values.maxCoeff<Eigen::PropagateNaN>(), -values.minCoeff<Eigen::PropagateNaN>(),
          values.maxCoeff<Eigen::PropagateNaN>() - values.minCoeff<Eigen::PropagateNaN>(),
          yield > 0 ? von_mises(stress) / yield : -1e300);
      for (int k = 0; k < 4; ++k) expected[k] = isopatch::larger(expected[k], of_point[k]);
    }
    // Values that differ by less than 1e-9 count as equal.
    EXPECT_NEAR(peaks.tension.value, expected[0], 1e-8);
    EXPECT_NEAR(peaks.compression.value, expected[1], 1e-8);
    EXPECT_NEAR(peaks.tresca.value, expected[2], 1e-8);
    EXPECT_NEAR(peaks.utilization.value, expected[3], 1e-8);
  }
}

TEST(StressPeaks, LeaveOutWhatWasSeenToBeExceeded) {
  StressPeaks seen, first, second;
  const auto here = [] { return Extremum{0, {}, 0, {}}; };
  const Eigen::Matrix3d high = 2 * Eigen::Matrix3d::Identity(), low = Eigen::Matrix3d::Identity();
  take(StressPoint{high, 0, 0}, here, seen, first);
  take(StressPoint{low, 0, 0}, here, seen, second);
  EXPECT_EQ(first.tension.value, 2);
  EXPECT_EQ(second.tension.patch, -1);
  EXPECT_EQ(second.compression.value,
            -1);  // the point is less compressed than nothing, but more than the other
  EXPECT_EQ(together(first, second).tension.value, 2);
}

TEST(StressPeaks, HaveNoUtilizationWithoutYieldStress) {
  StressPeaks peaks, seen;
  const Eigen::Matrix3d stress = Eigen::Matrix3d::Identity();
  take(
      StressPoint{stress, 1, 0},
      [] {
        return Extremum{0, {}, 0, {}};
      },
      seen, peaks);
  EXPECT_EQ(peaks.utilization.patch, -1);
  EXPECT_EQ(peaks.tension.patch, 0);
  EXPECT_EQ(together(peaks, {}).tension.value, 1);
}

}  // namespace
}  // namespace isopatch::iga
