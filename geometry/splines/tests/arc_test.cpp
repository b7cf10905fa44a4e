#include "geometry/splines/arc.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"

namespace isopatch::geometry {
namespace {

// Points are sums of three rounded products divided by a rounded sum: a few units of the last place.
constexpr double exact = 1e-15;

double worst_radius_error(const NurbsCurve& curve,
                          const std::function<double(const Eigen::Vector3d&)>& residual) {
  double worst = 0;
  for (int i = 0; i <= 200; ++i)
    worst = larger(worst, std::abs(residual(curve.point(Parameter<1>(i / 200.0)))));
  return worst;
}

std::string refusal(const std::function<void()>& make) {
  try {
    make();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "accepted";
}

TEST(Arc, EveryPointLiesOnTheCircle) {
  for (const double sweep : {1e-3, 10.0, 45.0, 90.0, 120.0, 170.0, -60.0, -150.0}) {
    const NurbsCurve curve = arc({0, 0, 0}, 3, Angle::degrees(25), Angle::degrees(25 + sweep));
    EXPECT_LE(worst_radius_error(curve, [](const auto& x) { return x.norm() / 3 - 1; }), exact) << sweep;
  }
}

TEST(Arc, BeginsAndEndsAtItsAnglesAndHalvesInTheMiddle) {
  const NurbsCurve curve = arc({1, 2, 3}, 2, Angle::degrees(90), Angle::degrees(30));
  const Eigen::Vector3d center(1, 2, 3);
  const auto at = [&](double t) { return Eigen::Vector3d(curve.point(Parameter<1>(t)) - center); };
  EXPECT_LE((at(0) - Eigen::Vector3d(0, 2, 0)).norm(), 4 * exact);
  EXPECT_LE((at(0.5) - Eigen::Vector3d(1, std::sqrt(3), 0)).norm(), 4 * exact);
  EXPECT_LE((at(1) - Eigen::Vector3d(std::sqrt(3), 1, 0)).norm(), 4 * exact);
}

TEST(Arc, AboutAnAxisStaysOnItsCircleInSpace) {
  const Eigen::Vector3d center(0.5, -1, 0.25);
  const Eigen::Vector3d axis(1, 2, -2);
  const Eigen::Vector3d start(2, 0.5, 1);
  const Eigen::Vector3d direction = axis.normalized();
  const NurbsCurve curve = arc_about(center, axis, start, Angle::degrees(130));
  const double height = direction.dot(start - center);
  const double radius = direction.cross(start - center).norm();
  EXPECT_LE(worst_radius_error(curve, [&](const auto& x) { return direction.dot(x - center) - height; }),
            2 * exact);
  EXPECT_LE(
      worst_radius_error(curve, [&](const auto& x) { return direction.cross(x - center).norm() - radius; }),
      2 * exact);
  const Eigen::AngleAxisd turn(Angle::degrees(130).radians(), direction);
  EXPECT_LE((curve.point(Parameter<1>(1)) - (center + turn * (start - center))).norm(), 4 * exact);
}

TEST(Arc, AboutZEqualsThePlanarArc) {
  const NurbsCurve planar = arc({1, 2, 3}, 2, Angle(), Angle::degrees(77));
  const NurbsCurve spatial = arc_about({1, 2, -5}, {0, 0, 4}, {3, 2, 3}, Angle::degrees(77));
  EXPECT_LE((planar.control_points() - spatial.control_points()).norm(), 4 * exact);
  EXPECT_EQ(planar.weights(), spatial.weights());
}

TEST(Arc, RefusesWhatOnePieceCannotBe) {
  EXPECT_THAT(refusal([] {
                arc({0, 0, 0}, 1, Angle(), Angle::degrees(180));
              }),
              testing::HasSubstr("arc of 180 deg"));
  EXPECT_THAT(refusal([] { arc({0, 0, 0}, 1, Angle(), Angle()); }), testing::HasSubstr("arc of 0 deg"));
  EXPECT_THAT(refusal([] {
                arc({0, 0, 0}, -1, Angle(), Angle::degrees(9));
              }),
              testing::HasSubstr("radius -1"));
  EXPECT_THAT(refusal([] {
                arc_about({0, 0, 0}, {0, 0, 0}, {1, 0, 0}, Angle::degrees(9));
              }),
              testing::HasSubstr("axis of no length"));
  EXPECT_THAT(refusal([] {
                arc_about({0, 0, 0}, {0, 0, 1}, {0, 0, 7}, Angle::degrees(9));
              }),
              testing::HasSubstr("its own axis"));
}

TEST(Arc, PieceCountIsNotMisledByRounding) {
  EXPECT_EQ(arc_piece_count(Angle::degrees(360)), 4);
  EXPECT_EQ(arc_piece_count(Angle::degrees(360), Angle::degrees(120)), 3);
  EXPECT_EQ(arc_piece_count(Angle::degrees(90.001)), 2);
  EXPECT_EQ(arc_piece_count(Angle::degrees(0.1) * 3, Angle::degrees(0.1)), 3);
  EXPECT_THAT(refusal([] { arc_piece_count(Angle()); }), testing::HasSubstr("divide 0 degrees"));
}

}  // namespace
}  // namespace isopatch::geometry
