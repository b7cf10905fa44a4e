#include "geometry/models/elbow.hpp"

#include <numbers>

#include "geometry/models/tests/model_checks.hpp"

namespace isopatch::geometry {
namespace {

using std::numbers::pi;

// Distance from the wall of radius r of the pipe with the default bend and inlet, before, in and behind the
// bend.
double wall_distance(const Eigen::Vector3d& x, double r) {
  if (x.z() <= 15) return x.head<2>().norm() - r;
  if (x.x() >= 20) return std::hypot(x.y(), x.z() - 35) - r;
  return std::hypot(std::hypot(x.x() - 20, x.z() - 15) - 20, x.y()) - r;
}

TEST(ElbowModel, HasExactWallsAndTheClosedFormsMeasures) {
  const MultiPatch model = expect_sound(elbow_model(), {12, 20, 32});
  const double length = 15 + 15 + 20 * pi / 2;  // Pappus: the axis carries the section
  EXPECT_NEAR(total_volume(model), 36 * pi * length, 36 * pi * length * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "inner"), 16 * pi * length, 16 * pi * length * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "inlet"), 36 * pi, 36 * pi * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "outlet"), 36 * pi, 36 * pi * quadrature_error);
  EXPECT_LE(worst(model, "inner", [](const Eigen::Vector3d& x) { return wall_distance(x, 8); }), 2e-14);
  EXPECT_LE(worst(model, "outer", [](const Eigen::Vector3d& x) { return wall_distance(x, 10); }), 2e-14);
  EXPECT_EQ(worst(model, "inlet", [](const Eigen::Vector3d& x) { return x.z(); }), 0);
  EXPECT_LE(worst(model, "outlet", [](const Eigen::Vector3d& x) { return x.x() - 35; }), 2e-14);
}

TEST(ElbowModel, BendsByAnyAngleAndNeedsNoStraightPipes) {
  for (const double degrees : {10.0, 135.0, 180.0}) {
    SCOPED_TRACE(degrees);
    const int bends = degrees > 90 ? 2 : 1;
    const MultiPatch model = expect_sound(
        elbow_model({.bend_angle = Angle::degrees(degrees), .inlet_length = 0, .outlet_length = 0}),
        {4 * bends, 4 * bends + 4 * (bends - 1), 8 * bends + 8});
    const double expected = 36 * pi * 20 * degrees * pi / 180;
    EXPECT_NEAR(total_volume(model), expected, expected * quadrature_error);
  }
}

TEST(ElbowModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { elbow_model({.bend_radius = 10}); },
                 {"elbow", "outer_radius is 10", "below bend_radius, 10"});
  expect_refused([] { elbow_model({.bend_angle = Angle::degrees(200)}); },
                 {"bend_angle is 200 degrees", "at most 180"});
  expect_refused([] { elbow_model({.outlet_length = -1}); }, {"outlet_length is -1", "0 or more"});
}

}  // namespace
}  // namespace isopatch::geometry
