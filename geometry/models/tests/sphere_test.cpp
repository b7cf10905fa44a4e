#include "geometry/models/sphere.hpp"

#include <numbers>

#include "geometry/measures.hpp"
#include "geometry/models/tests/model_checks.hpp"

namespace isopatch::geometry {
namespace {

using std::numbers::pi;

TEST(SphereModel, OctantHasExactWallsAndMeasures) {
  const MultiPatch model = expect_sound(sphere_model(), {3, 3, 12});
  const double expected = pi / 6 * (8 - 1);
  EXPECT_NEAR(total_volume(model), expected, quadrature_error * expected);
  EXPECT_NEAR(boundary_area(model, "inner"), pi / 2, pi / 2 * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "outer"), 2 * pi, 2 * pi * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "y0"), 0.75 * pi, 0.75 * pi * quadrature_error);
  EXPECT_LE(worst(model, "inner", [](const Eigen::Vector3d& x) { return x.norm() - 1; }), 1e-15);
  EXPECT_LE(worst(model, "outer", [](const Eigen::Vector3d& x) { return x.norm() - 2; }), 2e-15);
  EXPECT_EQ(worst(model, "x0", [](const Eigen::Vector3d& x) { return x.x(); }), 0);
  EXPECT_EQ(worst(model, "y0", [](const Eigen::Vector3d& x) { return x.y(); }), 0);
  EXPECT_EQ(worst(model, "z0", [](const Eigen::Vector3d& x) { return x.z(); }), 0);
}

TEST(SphereModel, RadiusGrowsAtConstantSpeed) {
  for (const NurbsVolume& patch : sphere_model().patches)
    for (const double t : {0.25, 0.5, 0.9}) EXPECT_NEAR(patch.point({0.3, 0.8, t}).norm(), 1 + t, 2e-15);
}

TEST(SphereModel, LayersAndThinShellsAreSound) {
  expect_sound(sphere_model({.radial_patches = 3}), {9, 9 + 6, 24});
  const MultiPatch thin = expect_sound(sphere_model({.inner_radius = 100, .outer_radius = 101}), {3, 3, 12});
  const double expected = pi / 6 * (101.0 * 101 * 101 - 100.0 * 100 * 100);
  EXPECT_NEAR(total_volume(thin), expected, quadrature_error * expected);
}

TEST(SphereModel, IsWellShaped) {
  // The corner on the diagonal has 120 degrees between its edges, which no octant of three patches avoids.
  for (const NurbsVolume& patch : sphere_model().patches) EXPECT_GT(quality(patch).min_scaled_jacobian, 0.85);
}

TEST(SphereModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { sphere_model({.inner_radius = 0}); },
                 {"sphere", "inner_radius is 0", "positive length"});
  expect_refused([] { sphere_model({.inner_radius = 3}); }, {"inner_radius is 3", "below outer_radius, 2"});
  expect_refused([] { sphere_model({.radial_patches = -1}); }, {"radial_patches is -1"});
}

}  // namespace
}  // namespace isopatch::geometry
