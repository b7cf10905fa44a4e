#include "geometry/loop_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/larger.hpp"

namespace isopatch::geometry {
namespace {

std::vector<LoopSegment> polygon(const std::vector<Eigen::Vector3d>& corners) {
  std::vector<LoopSegment> result;
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.emplace_back([a = corners[i], b = corners[(i + 1) % corners.size()]](double t) {
      return Eigen::Vector3d(a + t * (b - a));
    });
  return result;
}

TEST(LoopSurface, PassesSixCornersOneOfThemReflex) {
  const auto loop = polygon({{0, 0, 0.3}, {2, 0, 0}, {2, 1, -0.2}, {1, 1, 0.1}, {1, 2, 0}, {0, 2, 0.2}});
  const auto found = loop_surface(loop, 1e-6);
  ASSERT_TRUE(found);
  EXPECT_LT(found->deviation, 1e-6);
  double off = 0;
  for (const LoopSegment& curve : loop)
    for (int i = 0; i <= 97; ++i) {
      const Eigen::Vector3d point = curve(i / 97.0);
      off = larger(off, (found->surface.point(found->domain_point(point)) - point).norm());
    }
  EXPECT_LT(off, 2e-6);
  const auto axes = found->surface.jacobian(found->domain_point({0.5, 0.5, 0}));
  EXPECT_GT(axes.col(0).cross(axes.col(1)).z(), 0.8);  // counter-clockwise
}

TEST(LoopSurface, PassesCurvedEdges) {
  // A saddle over a disc, in three arcs.
  std::vector<LoopSegment> loop;
  for (int k = 0; k < 3; ++k)
    loop.emplace_back([k](double t) {
      const double angle = 2 * std::numbers::pi * (k + t) / 3;
      return Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.2 * std::cos(2 * angle));
    });
  const auto found = loop_surface(loop, 1e-5);
  ASSERT_TRUE(found);
  EXPECT_LT(found->deviation, 4e-5);
  // z = (x^2 - y^2) / 5 bends little among what passes there.
  EXPECT_NEAR(found->surface.point(found->domain_point({0.5, 0.2, 0})).z(), 0.2 * (0.25 - 0.04), 0.01);
}

TEST(LoopSurface, ThereIsNoneOverAPlaneWhereTheLoopCrossesItselfThere) {
  EXPECT_FALSE(loop_surface(polygon({{0, 0, 0}, {2, 2, 0.1}, {2, 0, 0}, {0, 1, 0.1}}), 1e-6));
  EXPECT_FALSE(loop_surface(polygon({{0, 0, 0}, {1, 1, 0}}), 1e-6));
}

}  // namespace
}  // namespace isopatch::geometry
