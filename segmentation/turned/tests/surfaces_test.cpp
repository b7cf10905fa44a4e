#include "segmentation/turned/internal/surfaces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/splines/arc.hpp"

namespace isopatch::segmentation {
namespace {

const Eigen::Vector3d centre(1, -2, 3), middle = Eigen::Vector3d(2, 1, -2) / 3;

TEST(SpherePatch, IsRoundAllAround) {
  for (const bool inwards : {false, true}) {
    const SpherePatch patch({centre, 2.5, Eigen::Vector3d::UnitZ()}, middle, inwards);
    const geometry::NurbsSurface surface = patch.surface(1.7);
    for (const double u : {-1.7, -0.4, 0.0, 0.9, 1.7})
      for (const double v : {-1.2, 0.1, 1.6}) {
        const Eigen::Vector3d out = surface.point({u, v}) - centre;
        EXPECT_NEAR(out.norm(), 2.5, 1e-14);
        const auto along = surface.jacobian({u, v});
        EXPECT_NEAR(along.col(0).cross(along.col(1)).normalized().dot(out), inwards ? -2.5 : 2.5, 1e-13);
      }
    EXPECT_LT((surface.point({0, 0}) - centre - 2.5 * middle).norm(), 1e-14);
  }
}

TEST(SpherePatch, HasTracesAtThePaceOfTheirCurves) {
  const Spheroid flat{centre, 2.5, Eigen::Vector3d(0.6, 0, 0.8), 0.5};
  const SpherePatch patch(flat, middle, false);
  const geometry::NurbsSurface surface = patch.surface(2);
  const geometry::NurbsCurve arc = flat.arc(flat.stretched(centre + 2.5 * Eigen::Vector3d(0.8, 0.6, 0)),
                                            flat.stretched(centre + 2.5 * Eigen::Vector3d(0, 0.6, -0.8)));
  const geometry::NurbsCurve trace = patch.trace(arc);
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const geometry::Parameter<1> at(t);
    EXPECT_LT((surface.point(trace.point(at).head<2>()) - arc.point(at)).norm(), 1e-13);
  }
}

TEST(TurnedSurface, RunsThroughTheCurveTurned) {
  const Eigen::Vector3d origin(1, 0, 0), axis(0, 0, 1);
  const geometry::NurbsCurve curve = geometry::segment({3, 0.5, 0}, {4, -0.3, 2});
  const double sweep = std::numbers::pi / 2;
  const geometry::NurbsSurface surface = turned_surface(curve, origin, axis, sweep);
  for (const double t : {0.0, 0.3, 1.0}) {
    const Eigen::Vector3d way = curve.point(geometry::Parameter<1>(t)) - origin;
    const Eigen::Vector3d end = origin + Eigen::AngleAxisd(sweep, axis) * way;
    EXPECT_LT((surface.point({0, t}) - origin - way).norm(), 1e-14);
    EXPECT_LT((surface.point({1, t}) - end).norm(), 1e-14);
    const Eigen::Vector3d inside = surface.point({0.3, t}) - origin;
    EXPECT_NEAR(inside.head<2>().norm(), way.head<2>().norm(), 1e-14);
    EXPECT_NEAR(inside.z(), way.z(), 1e-14);
  }
}

}  // namespace
}  // namespace isopatch::segmentation
