#include "iga/problem/held_area.hpp"

#include <gtest/gtest.h>

#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;

// The side z = 0 of a cube in 4 x 4 elements of degree 1.
ElasticityProblem quarters(const Region& region) {
  const auto model = geometry::connect(geometry::box_model({}));
  ElasticityProblem p =
      testing::problem(model, {.degree = {1, 1, 1}, .elements_per_direction = {4, 4, 1}}, isotropic(1e3, 0));
  p.supports = {{.name = "bed",
                 .faces = boundary(model, "z_min"),
                 .condition = PrescribedDisplacement{},
                 .region = region}};
  return p;
}

HeldArea area_of(const Region& region) {
  const ElasticityProblem p = quarters(region);
  return held_area(p.discretization.patches, p.supports[0]);
}

TEST(HeldArea, OfWholeFacesIsTheirs) {
  const HeldArea area = area_of({});
  EXPECT_NEAR(area.asked, 1, 1e-14);
  EXPECT_NEAR(area.held, 1, 1e-14);
  EXPECT_TRUE(area.has_element);
}

// Functions of the nodes at x = 0, 0.25 and 0.5 are held, the last of which reaches on to 0.75.
TEST(HeldArea, OfAHalfReachesHalfAnElementOn) {
  const HeldArea area = area_of(half_space({0.5, 0, 0}, {-1, 0, 0}));
  EXPECT_NEAR(area.asked, 0.5, 1e-14);
  EXPECT_NEAR(area.held, 0.125 + 0.25 + 0.25, 1e-14);
  EXPECT_TRUE(area.has_element);
}

TEST(HeldArea, OfLessThanAnElementHasNone) {
  const HeldArea area = area_of(inside_box({0.2, 0.2, -1}, {0.3, 0.3, 1}));
  EXPECT_NEAR(area.asked, 0.01, 1e-8);  // corners of regions: 1e-8 of an element
  EXPECT_NEAR(area.held, 0.25 * 0.25, 1e-14);
  EXPECT_FALSE(area.has_element);
}

// Springs under two parts of the bottom carry a cube that cannot tilt as springs side by side do.
TEST(ElasticSupport, OnPartsOfAFaceCarriesWithTheirAreas) {
  ElasticityProblem p = quarters({});
  p.materials[0] = isotropic(1e7, 0);  // by 3e4 stiffer than the springs
  const auto& model = p.discretization.model;
  const auto bottom = boundary(model, "z_min");
  const Region left = half_space({0.375, 0, 0}, {-1, 0, 0}), right = half_space({0.375, 0, 0}, {1, 0, 0});
  const PrescribedDisplacement upright{{0.0, 0.0, std::nullopt}};
  p.supports = {{.name = "left", .faces = bottom, .condition = ElasticSupport{300, 0}, .region = left},
                {.name = "right", .faces = bottom, .condition = ElasticSupport{100, 0}, .region = right}};
  for (const char* side : {"x_min", "x_max", "y_min", "y_max"})
    p.supports.push_back({.name = side, .faces = boundary(model, side), .condition = upright});
  p.surface_loads = {pressure_load("press", boundary(model, "z_max"), 7)};
  const ElasticityResults results = solve_elasticity(p).results;
  const double within = 7 * 3e-5;  // the cube gives way by so much of what the springs do
  const double stiffness = 300 * 0.375 + 100 * 0.625;
  EXPECT_NEAR(results.reactions[0].force[2], 7 * 300 * 0.375 / stiffness, within);
  EXPECT_NEAR(results.reactions[1].force[2], 7 * 100 * 0.625 / stiffness, within);
}

}  // namespace
}  // namespace isopatch::iga
