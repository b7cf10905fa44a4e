#include <gtest/gtest.h>

#include <cmath>

#include "iga/solution/condition.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

ElasticField bar_of(const Material& left, const Material& right) {
  const auto model = geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  ElasticField field;
  field.patches = model.patches();
  field.materials = {left, right};
  return field;
}

TEST(LocateSides, AreOneForEachMaterialThatMeetsThere) {
  const ElasticField two = bar_of(isotropic(1, 0), isotropic(2, 0));
  const auto between = locate_sides(two, {1, 0.3, 0.6}, 1e-9);
  ASSERT_EQ(between.size(), 2u);
  EXPECT_NE(between[0].patch, between[1].patch);
  for (const Location& side : between) EXPECT_LT(side.distance, 1e-14);
  EXPECT_EQ(locate_sides(two, {0.5, 0.3, 0.6}, 1e-9).size(), 1u);
  EXPECT_EQ(locate_sides(two, {0.9, 0.3, 0.6}, 0.2).size(), 2u);
  EXPECT_EQ(locate_sides(bar_of(isotropic(1, 0), isotropic(1, 0)), {1, 0.3, 0.6}, 1e-9).size(), 1u);
}

// As elements are halved the largest eigenvalue falls as their size, the smallest as their volume.
TEST(EstimateCondition, GrowsWithTheSquareOfTheElements) {
  const auto number = [](int elements, Coupling coupling) {
    const auto model = geometry::connect(geometry::box_model({.patches = {2, 1, 1}}));
    ElasticityProblem p = testing::problem(
        model, {.degree = {1, 1, 1}, .elements_per_direction = {elements, elements, elements}},
        isotropic(1, 0));
    p.supports = {{"bed", testing::boundary(model, "z_min"), PrescribedDisplacement{}}};
    return estimate_condition(p, coupling).number();
  };
  const double coarse = number(2, Coupling::elimination), fine = number(4, Coupling::elimination);
  EXPECT_NEAR(std::log2(fine / coarse), 2, 0.4);
  // Multipliers are scaled to the matrix: their eigenvalues lie between those of the stiffness.
  EXPECT_NEAR(number(2, Coupling::lagrange) / coarse, 1, 0.02);
}

}  // namespace
}  // namespace isopatch::iga
