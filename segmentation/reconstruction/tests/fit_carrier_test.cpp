#include "segmentation/reconstruction/internal/fit_carrier.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/carrier_domain.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::SurfaceKind;

/// A grid of points on a carrier, its cells cut by diagonals into triangles.
SurfaceSample grid_on(const Carrier& carrier, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                      int steps) {
  const CarrierDomain domain(carrier);
  const auto at = [&](int i, int j) -> Eigen::Vector3d {
    return domain.point(
        {low.x() + (high.x() - low.x()) * i / steps, low.y() + (high.y() - low.y()) * j / steps});
  };
  SurfaceSample result;
  result.points.resize(3, (steps + 1) * (steps + 1));
  result.normals.resize(3, 2 * steps * steps);
  result.middles.resize(3, 2 * steps * steps);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) result.points.col(i * (steps + 1) + j) = at(i, j);
  int next = 0;
  const auto add = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    result.normals.col(next) = (b - a).cross(c - a).normalized();
    result.middles.col(next++) = (a + b + c) / 3;
  };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return result;
}

Carrier made(SurfaceKind kind, double radius, double second, double degrees) {
  return {kind,   {0.3, -0.2, 0.5}, Eigen::Vector3d(1, 2, -1.5).normalized(),
          radius, second,           Angle::degrees(degrees)};
}

struct Case {
  const char* name;
  Carrier carrier;
  Eigen::Vector2d low, high;
  int steps;
};

const std::array<Case, 7> cases{{
    {"cylinder", made(SurfaceKind::cylinder, 0.7, 0, 0), {0, -1}, {1, 1}, 4},
    {"cone", made(SurfaceKind::cone, 0.7, 0, 30), {0, -0.3}, {1, 0.4}, 4},
    {"blunt cone", made(SurfaceKind::cone, 0.7, 0, 80), {0, -0.03}, {1, 0.04}, 4},
    {"sphere", made(SurfaceKind::sphere, 0.7, 0, 0), {0, -0.3}, {0.5, 0.4}, 4},
    {"torus", made(SurfaceKind::torus, 0.7, 0.2, 0), {0, 0.1}, {0.6, 1}, 4},
    {"narrow torus", made(SurfaceKind::torus, 0.7, 0.02, 0), {0, 0}, {6, 1.5}, 6},
    {"crowned", made(SurfaceKind::torus, 0.15, 1, 0), {0, 0.9}, {1.5, 1.3}, 8},
}};

TEST(FitCarrier, FindsWhatPointsLieOn) {
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const SurfaceSample sample = grid_on(one.carrier, one.low, one.high, one.steps);
    const auto found = fit_carrier(one.carrier.kind, sample);
    ASSERT_TRUE(found);
    EXPECT_LT(found->largest, 1e-11);
    EXPECT_NEAR(found->carrier.radius,
                one.carrier.kind == SurfaceKind::cone ? found->carrier.radius : one.carrier.radius, 1e-7);
    EXPECT_NEAR(found->carrier.second_radius, one.carrier.second_radius, 1e-7);
    EXPECT_NEAR(found->carrier.half_angle.degrees(), one.carrier.half_angle.degrees(), 1e-6);
  }
}

TEST(FitCarrier, FindsTheSameWhereItMayGiveUp) {
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const SurfaceSample sample = grid_on(one.carrier, one.low, one.high, one.steps);
    const auto found = fit_carrier(one.carrier.kind, sample, 1e-6);
    ASSERT_TRUE(found);
    EXPECT_LT(found->largest, 1e-11);
  }
}

TEST(FitCarrier, GivesUpWherePointsStayFarther) {
  // A torus is no cylinder, cone or sphere within a thousandth of its tube's radius: the arcs there are of a
  // radian, so that half their height over a chord is an eighth of it.
  const SurfaceSample sample = grid_on(made(SurfaceKind::torus, 0.7, 0.2, 0), {0, 0.1}, {0.6, 1}, 4);
  for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::cone, SurfaceKind::sphere}) {
    SCOPED_TRACE(static_cast<int>(kind));
    EXPECT_FALSE(fit_carrier(kind, sample, 2e-4));
    const auto to_the_end = fit_carrier(kind, sample);
    ASSERT_TRUE(to_the_end);
    EXPECT_GT(to_the_end->largest, 2e-4);
  }
}

TEST(FitCarrier, DistancesHaveTheirDerivatives) {
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const Eigen::Vector3d point =
        CarrierDomain(one.carrier).point((one.low + one.high) / 2) + Eigen::Vector3d(0.01, 0.02, -0.015);
    const CarrierDistance here = carrier_distance(one.carrier, point);
    EXPECT_NEAR(here.gradient.norm(), 1, 1e-12);
    const double step = 1e-6;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d way = step * Eigen::Vector3d::Unit(i);
      const double slope = (carrier_distance(one.carrier, point + way).value -
                            carrier_distance(one.carrier, point - way).value) /
                           (2 * step);
      EXPECT_NEAR(slope, here.gradient[i], 1e-8);
    }
    Carrier more = one.carrier, less = one.carrier;
    more.radius += step;
    less.radius -= step;
    EXPECT_NEAR((carrier_distance(more, point).value - carrier_distance(less, point).value) / (2 * step),
                here.by_radius, 1e-8);
  }
}

TEST(FitCarrier, SaysNothingForTooFewPoints) {
  SurfaceSample sample = grid_on(cases[0].carrier, cases[0].low, cases[0].high, 1);
  EXPECT_FALSE(fit_carrier(SurfaceKind::torus, sample));
}

}  // namespace
}  // namespace isopatch::segmentation
