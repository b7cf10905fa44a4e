#include "geometry/splines/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/permute.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

// Knot insertion and degree elevation cost a few roundings more than evaluation.
constexpr double nearly_exact = 1e-14;

Eigen::Vector3d at(const NurbsCurve& curve, double t) {
  return curve.point(Parameter<1>(t));
}
Eigen::Vector3d at(const NurbsSurface& surface, double s, double t) {
  return surface.point({s, t});
}

TEST(Ruled, MeetsBothCurvesAlthoughDegreesAndKnotsDiffer) {
  const NurbsCurve low = insert_knots(arc({0, 0, 0}, 1, Angle(), Angle::degrees(100)), 0, {0.3});
  const NurbsCurve high = insert_knots(elevate_degree(segment({3, 0, 1}, {0, 4, 2}), 0, 2), 0, {0.3, 0.6});
  const NurbsSurface surface = ruled(low, high);
  EXPECT_EQ(surface.degree(0), 3);
  EXPECT_EQ(surface.degree(1), 1);
  for (const double t : {0.0, 0.1, 0.3, 0.45, 0.6, 0.99, 1.0}) {
    EXPECT_LE((at(surface, t, 0) - at(low, t)).norm(), nearly_exact);
    EXPECT_LE((at(surface, t, 1) - at(high, t)).norm(), nearly_exact);
    // The ruling is straight: the middle lies between the ends.
    const Eigen::Vector3d chord = at(high, t) - at(low, t);
    EXPECT_LE(chord.normalized().cross(at(surface, t, 0.5) - at(low, t)).norm(), nearly_exact);
  }
}

TEST(Ruled, EqualWeightsGiveConstantSpeedAcross) {
  const NurbsSurface inner = extruded(arc({0, 0, 0}, 1, Angle(), Angle::degrees(90)), {0, 0, 1});
  const NurbsSurface outer = extruded(arc({0, 0, 0}, 2, Angle(), Angle::degrees(90)), {0, 0, 1});
  const NurbsVolume wall = ruled(inner, outer);
  for (const double t : {0.0, 0.25, 0.7, 1.0})
    EXPECT_NEAR(wall.point({0.37, 0.5, t}).head<2>().norm(), 1 + t, nearly_exact);
}

TEST(Ruled, RefusesDifferentParameterRanges) {
  const NurbsCurve longer({KnotVector::bezier(1, 0, 2)}, segment({0, 1, 0}, {1, 1, 0}).control_points());
  try {
    ruled(segment({0, 0, 0}, {1, 0, 0}), longer);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_THAT(error.what(), testing::HasSubstr("over [0, 1] with one over [0, 2]"));
  }
}

TEST(Extruded, MovesEveryPointAlongTheVector) {
  const NurbsSurface base =
      ruled(arc({0, 0, 0}, 1, Angle(), Angle::degrees(80)), segment({2, 0, 0}, {0, 2, 0}));
  const Eigen::Vector3d vector(1, -2, 3);
  const NurbsVolume volume = extruded(base, vector);
  for (const double t : {0.0, 0.4, 1.0})
    EXPECT_LE((volume.point({0.3, 0.8, t}) - (at(base, 0.3, 0.8) + t * vector)).norm(), nearly_exact);
  EXPECT_ERROR(extruded(base, Eigen::Vector3d::Zero()), ErrorCode::invalid_argument,
               "along a vector of no length");
}

TEST(Revolved, TurnsEveryPointAboutTheAxis) {
  const NurbsSurface base =
      ruled(arc({5, 0, 0}, 1, Angle(), Angle::degrees(90)), segment({7, 0, 0}, {5, 2, 0}));
  const Eigen::Vector3d center(1, 0, 2);
  const Eigen::Vector3d axis(0, 3, 1);
  const Angle sweep = Angle::degrees(-140);
  const NurbsVolume volume = revolved(base, center, axis, sweep);
  const Eigen::Vector3d direction = axis.normalized();
  for (const double s : {0.0, 0.35, 1.0}) {
    const Eigen::Vector3d start = at(base, s, 0.6);
    // Half the parameter is half the angle, whatever the sweep.
    for (const double t : {0.0, 0.5, 1.0}) {
      const Eigen::AngleAxisd turn(t * sweep.radians(), direction);
      EXPECT_LE((volume.point({s, 0.6, t}) - (center + turn * (start - center))).norm(), nearly_exact);
    }
    const double radius = direction.cross(start - center).norm();
    for (const double t : {0.1, 0.3, 0.8})
      EXPECT_NEAR(direction.cross(volume.point({s, 0.6, t}) - center).norm(), radius, nearly_exact);
  }
}

TEST(Revolved, RefusesWhatOnePieceCannotBe) {
  const NurbsSurface base;
  EXPECT_ERROR(revolved(base, {0, 0, 0}, {0, 1, 0}, Angle::degrees(180)), ErrorCode::invalid_argument,
               "a revolution by 180 degrees");
  EXPECT_ERROR(revolved(base, {0, 0, 0}, {0, 1, 0}, Angle()), ErrorCode::invalid_argument,
               "a revolution by 0 degrees");
  EXPECT_ERROR(revolved(base, {0, 0, 0}, {0, 0, 0}, Angle::degrees(90)), ErrorCode::invalid_argument,
               "about an axis of no length");
}

TEST(Permuted, ExchangesTheParametersOnly) {
  const NurbsSurface base =
      ruled(arc({0, 0, 0}, 1, Angle(), Angle::degrees(80)), segment({2, 0, 0}, {0, 2, 0}));
  const NurbsVolume volume =
      insert_knots(revolved(base, {-1, 0, 0}, {0, 1, 0}, Angle::degrees(50)), 2, {0.2});
  const std::array<double, 3> old = {0.1, 0.6, 0.8};
  std::array<int, 3> from = {0, 1, 2};
  do {
    const NurbsVolume other = permuted<3>(volume, from);
    Parameter<3> parameter;
    for (int d = 0; d < 3; ++d)
      parameter[d] = old[static_cast<std::size_t>(from[static_cast<std::size_t>(d)])];
    EXPECT_EQ(other.degree(0), volume.degree(from[0]));
    EXPECT_LE((other.point(parameter) - volume.point({0.1, 0.6, 0.8})).norm(), nearly_exact);
  } while (std::next_permutation(from.begin(), from.end()));
  EXPECT_ERROR(permuted<3>(volume, {0, 1, 1}), ErrorCode::invalid_argument, "exactly once");
}

}  // namespace
}  // namespace isopatch::geometry
