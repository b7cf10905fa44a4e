#include "geometry/smooth_surface.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::geometry {
namespace {

TEST(SmoothSurface, GivesBackThePlaneAndWhatItPasses) {
  const std::array<KnotVector, 2> knots = {KnotVector::uniform(3, 5),
                                           rescaled(KnotVector::uniform(2, 4), 1, 3)};
  SurfacePoints plane{(Eigen::Matrix2Xd(2, 4) << 0, 1, 0.9, 0.2, 1, 1.1, 2.8, 3).finished(),
                      Eigen::Matrix3Xd(3, 4)};
  for (int i = 0; i < 4; ++i)
    plane.points.col(i) << 2 * plane.uv(0, i), plane.uv(1, i) - 1, 5 - plane.uv(0, i) + 3 * plane.uv(1, i);
  const NurbsSurface flat = smooth_surface(plane, knots);
  const Eigen::Vector2d inside(0.3, 2.1);
  EXPECT_LT((flat.point(inside) - Eigen::Vector3d(0.6, 1.1, 5 - 0.3 + 6.3)).norm(), 1e-9);
  plane.points(2, 2) += 1;
  const NurbsSurface bent = smooth_surface(plane, knots);
  for (int i = 0; i < 4; ++i)
    EXPECT_LT((bent.point(Parameter<2>(plane.uv.col(i))) - plane.points.col(i)).norm(), 1e-9);
}

TEST(SmoothSurface, PointsOnOneLineAreRefused) {
  const std::array<KnotVector, 2> knots = {KnotVector::uniform(2, 2), KnotVector::uniform(2, 2)};
  EXPECT_ERROR(smooth_surface({Eigen::Matrix2Xd::Zero(2, 2), Eigen::Matrix3Xd::Zero(3, 2)}, knots),
               ErrorCode::invalid_argument, "three");
  // Along u: any plane through the line bends as little.
  const SurfacePoints line{(Eigen::Matrix2Xd(2, 4) << 0, 0.2, 0.7, 1, 0.5, 0.5, 0.5, 0.5).finished(),
                           (Eigen::Matrix3Xd(3, 4) << 0, 0.2, 0.7, 1, 0, 0, 0, 0, 0, 0, 0, 0).finished()};
  EXPECT_ERROR(smooth_surface(line, knots), ErrorCode::invalid_argument, "lie on one line of its domain");
}

}  // namespace
}  // namespace isopatch::geometry
