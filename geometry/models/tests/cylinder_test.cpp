#include "geometry/models/cylinder.hpp"

#include <numbers>

#include "geometry/models/tests/model_checks.hpp"

namespace isopatch::geometry {
namespace {

using std::numbers::pi;

double radius(const Eigen::Vector3d& x) {
  return x.head<2>().norm();
}

TEST(CylinderModel, QuarterHasExactWallsAndMeasures) {
  const MultiPatch model = expect_sound(cylinder_model(), {1, 0, 6});
  EXPECT_NEAR(total_volume(model), 0.375 * pi, quadrature_error);
  EXPECT_NEAR(boundary_area(model, "inner"), 0.25 * pi, quadrature_error);
  EXPECT_NEAR(boundary_area(model, "outer"), 0.5 * pi, quadrature_error);
  EXPECT_NEAR(boundary_area(model, "start"), 0.5, round_off);
  EXPECT_LE(worst(model, "inner", [](const Eigen::Vector3d& x) { return radius(x) - 1; }), 1e-15);
  EXPECT_LE(worst(model, "outer", [](const Eigen::Vector3d& x) { return radius(x) - 2; }), 1e-15);
  EXPECT_LE(worst(model, "start", [](const Eigen::Vector3d& x) { return x.y(); }), 1e-15);
  EXPECT_LE(worst(model, "end", [](const Eigen::Vector3d& x) { return x.x(); }), 1e-15);
  EXPECT_EQ(worst(model, "bottom", [](const Eigen::Vector3d& x) { return x.z(); }), 0);
  EXPECT_EQ(worst(model, "top", [](const Eigen::Vector3d& x) { return x.z() - 0.5; }), 0);
}

TEST(CylinderModel, FullTurnIsAClosedRing) {
  const MultiPatch model =
      expect_sound(cylinder_model({.angle = Angle::degrees(360), .radial_patches = 2, .axial_patches = 3}),
                   {24, 12 + 24 + 16, 40});
  EXPECT_NEAR(total_volume(model), 1.5 * pi, 4 * quadrature_error);
  for (const Boundary& boundary : model.boundaries())
    EXPECT_TRUE(boundary.name != "start" && boundary.name != "end");
}

TEST(CylinderModel, TakesAnyAngleInPiecesOfAtMostNinetyDegrees) {
  for (const double degrees : {1.0, 89.9, 90.0, 90.1, 180.0, 270.0, 359.0}) {
    SCOPED_TRACE(degrees);
    const int pieces = static_cast<int>(std::ceil(degrees / 90));
    const MultiPatch model = expect_sound(cylinder_model({.angle = Angle::degrees(degrees)}),
                                          {pieces, pieces - 1, 4 * pieces + 2});
    EXPECT_NEAR(total_volume(model), 1.5 * pi * degrees / 360, 4 * quadrature_error);
  }
}

TEST(CylinderModel, TakesThreePiecesForAFullTurnIfAsked) {
  expect_sound(cylinder_model({.angle = Angle::degrees(360), .patches_around = 3}), {3, 3, 12});
}

TEST(CylinderModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { cylinder_model({.inner_radius = 2}); },
                 {"cylinder", "inner_radius is 2", "outer_radius, 2"});
  expect_refused([] { cylinder_model({.height = 0}); }, {"height is 0", "positive length"});
  expect_refused([] { cylinder_model({.angle = Angle::degrees(361)}); },
                 {"angle is 361 degrees", "at most 360"});
  expect_refused([] { cylinder_model({.angle = Angle()}); }, {"angle is 0 degrees", "above 0"});
  expect_refused([] { cylinder_model({.angle = Angle::degrees(180), .patches_around = 1}); },
                 {"patches_around is 1", "between 2 and 1000"});
}

}  // namespace
}  // namespace isopatch::geometry
