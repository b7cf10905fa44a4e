#include "iga/problem/region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Vector3d;

TEST(Region, DistancesNearASurfaceAreThoseFromIt) {
  const Quadric sphere = inside_sphere({1, 2, 3}, 2).bounds.front();
  const Quadric cylinder = inside_cylinder({1, 2, 3}, {0, 0, 5}, 2).bounds.front();
  const Quadric plane = half_space({1, 2, 3}, {4, 0, 0}).bounds.front();
  // The second-order term is distance^2 / (2 R).
  for (const double distance : {-1e-3, 0.0, 1e-3}) {
    EXPECT_NEAR(sphere.at(Vector3d(1, 2, 3 + 2 - distance)), distance, 1e-6);
    EXPECT_NEAR(cylinder.at(Vector3d(1, 2 + 2 - distance, 17)), distance, 1e-6);
    EXPECT_NEAR(plane.at(Vector3d(1 + distance, -5, 8)), distance, 1e-15);
  }
}

TEST(Region, OfTwoHasWhatIsInBoth) {
  const Region half_ball = inside_sphere(Vector3d::Zero(), 1) & half_space(Vector3d::Zero(), {1, 0, 0});
  EXPECT_TRUE(half_ball.contains({0.5, 0, 0}));
  EXPECT_FALSE(half_ball.contains({-0.5, 0, 0}));
  EXPECT_FALSE(half_ball.contains({1.5, 0, 0}));
  EXPECT_TRUE(half_ball.contains({-0.01, 0, 0}, 0.02)) << "within the slack";
  EXPECT_TRUE(Region().is_everywhere());
  EXPECT_TRUE(Region().contains({1e9, 0, 0}));
}

TEST(Region, WithoutSizeOrDirectionIsRefused) {
  const Vector3d zero = Vector3d::Zero(), x = Vector3d::UnitX();
  const Vector3d unknown(std::nan(""), 0, 1);
  for (const double radius : {0.0, -1.0, std::nan("")}) {
    EXPECT_ERROR(inside_sphere(zero, radius), ErrorCode::invalid_argument, "radius above 0");
    EXPECT_ERROR(inside_cylinder(zero, x, radius), ErrorCode::invalid_argument, "radius above 0");
  }
  for (const Vector3d& direction : {zero, unknown}) {
    EXPECT_ERROR(half_space(zero, direction), ErrorCode::invalid_argument, "a normal that is not 0");
    EXPECT_ERROR(inside_cylinder(zero, direction, 1), ErrorCode::invalid_argument, "an axis that is not 0");
  }
  EXPECT_ERROR(inside_box({0, 0, 0}, {1, 0, 1}), ErrorCode::invalid_argument, "has no volume");
}

}  // namespace
}  // namespace isopatch::iga
