#include "segmentation/sweeps/interpolate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::segmentation {
namespace {

double largest_distance(const geometry::NurbsCurve& made, const auto& curve) {
  Eigen::VectorXd distances(1001);
  for (Eigen::Index i = 0; i < distances.size(); ++i) {
    const double t = static_cast<double>(i) / 1000;
    distances[i] = (made.point(geometry::Parameter<1>(t)) - curve(t)).norm();
  }
  return distances.maxCoeff<Eigen::PropagateNaN>();
}

/// Its third derivative jumps, as that of a cubic spline does at a knot.
Eigen::Vector3d with_a_knot(double t) {
  return {t, t > 0.3 ? std::pow(t - 0.3, 3) : 0, 0};
}

TEST(Interpolated, FollowsASplineAcrossItsKnots) {
  EXPECT_GT(largest_distance(interpolated(with_a_knot), with_a_knot), 1e-6);  // so it takes halving
  const geometry::NurbsCurve made = interpolated(with_a_knot, 1e-10);
  EXPECT_LT(largest_distance(made, with_a_knot), 2e-10);  // measured between its places
  EXPECT_LT(made.size(), 200);  // halved where the knot is; equal spans would have to be some 800
}

TEST(Interpolated, TakesNoMorePointsOfASmoothCurve) {
  const auto smooth = [](double t) { return Eigen::Vector3d(std::cos(t), std::sin(t), 0); };
  EXPECT_EQ(interpolated(smooth, 1e-8).control_points(), interpolated(smooth).control_points());
}

TEST(Interpolated, RefusesCorners) {
  const auto corner = [](double t) { return Eigen::Vector3d(t, std::abs(t - 0.3), 0); };
  EXPECT_ERROR(interpolated(corner, 1e-10), ErrorCode::unsupported, "corners");
}

}  // namespace
}  // namespace isopatch::segmentation
