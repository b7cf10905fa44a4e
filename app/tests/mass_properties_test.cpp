#include "app/problem/mass_properties.hpp"

#include <gtest/gtest.h>

#include "geometry/models/box.hpp"

namespace isopatch::app {
namespace {

TEST(MassProperties, OfTwoBlocksAreTheSumAboutTheCommonCentre) {
  // Cubes of 1 m beside each other in x, of 1000 and 3000 kg.
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  const auto found =
      mass_properties(model, {iga::isotropic(1e9, 0.3, 1000), iga::isotropic(1e9, 0.3, 3000)}).value();
  EXPECT_NEAR(found.mass, 4000, 1e-9);
  EXPECT_LT((found.centre - Eigen::Vector3d(1.25, 0.5, 0.5)).norm(), 1e-12);
  // m / 6 of each cube, and m d^2 of their distances 0.75 and 0.25 from the centre.
  const double own = 4000. / 6, shift = 1000 * 0.75 * 0.75 + 3000 * 0.25 * 0.25;
  EXPECT_LT(
      (found.inertia - Eigen::Vector3d(own, own + shift, own + shift).asDiagonal().toDenseMatrix()).norm(),
      1e-9);
}

TEST(MassProperties, HaveProductsOfInertiaWithTheirSign) {
  // Heavy cubes at the ends of a diagonal of four, in x and y.
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {2, 2, 1}, .patches = {2, 2, 1}}));
  const auto light = iga::isotropic(1e9, 0.3, 1e-3), heavy = iga::isotropic(1e9, 0.3, 1000);
  const auto found = mass_properties(model, {heavy, light, light, heavy}).value();
  // -m x y of centres at (-1/2, -1/2) and (1/2, 1/2); the light ones have the other sign.
  EXPECT_NEAR(found.inertia(0, 1), -(1000 - 1e-3) * 0.5, 1e-9);
  EXPECT_NEAR(found.inertia(1, 0), found.inertia(0, 1), 1e-9);
  EXPECT_NEAR(found.inertia(0, 2), 0, 1e-9);
}

TEST(MassProperties, NeedEachDensity) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  EXPECT_FALSE(mass_properties(model, {iga::isotropic(1e9, 0.3, 1000), iga::isotropic(1e9, 0.3)}));
}

}  // namespace
}  // namespace isopatch::app
