// A NaN in a solution, one or nothing else, is one in every figure that claims are made of.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "geometry/models/box.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "verification/suites/exact_solution.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/node_forces.hpp"

namespace isopatch::verification {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Two cubes beside each other under a linear displacement of their surface, tied by multipliers.
struct Solved {
  iga::ElasticityProblem problem;
  iga::ElasticitySolution solution;
};

Solved two_cubes() {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.patches = {2, 1, 1}}));
  iga::ElasticityProblem problem{iga::discretize(model, {.degree = {2, 2, 2}}),
                                 std::vector<iga::Material>(2, iga::isotropic(1e9, 0.3)),
                                 {},
                                 {},
                                 {}};
  problem.supports = {{"x_min", faces_of(model, "x_min"), generic_linear_field().prescribed()},
                      {"x_max", faces_of(model, "x_max"), generic_linear_field().prescribed()}};
  iga::ElasticitySolution solution = iga::solve_elasticity(problem, {.coupling = iga::Coupling::lagrange});
  return {std::move(problem), std::move(solution)};
}

using Figure = std::function<double(const iga::ElasticField&)>;

// Of a field with one NaN at any of its coefficients, and of one that is nothing else.
void expect_nan_in(const iga::ElasticField& field, const Figure& figure) {
  ASSERT_TRUE(std::isfinite(figure(field)));
  for (std::size_t p = 0; p < field.displacement.size(); ++p)
    for (Eigen::Index i = 0; i < field.displacement[p].size(); ++i) {
      iga::ElasticField broken = field;
      broken.displacement[p].reshaped()[i] = nan;
      EXPECT_TRUE(std::isnan(figure(broken))) << "patch " << p << " coefficient " << i;
    }
  iga::ElasticField nothing = field;
  for (Eigen::Matrix3Xd& u : nothing.displacement) u.setConstant(nan);
  EXPECT_TRUE(std::isnan(figure(nothing)));
}

TEST(NotANumber, IsInCoefficientErrors) {
  const iga::ElasticField field = two_cubes().solution.field;
  expect_nan_in(field, [](const auto& broken) { return coefficient_error(broken, generic_linear_field()); });
}

TEST(NotANumber, IsInCoefficientDifferencesFromEitherSide) {
  const iga::ElasticField field = two_cubes().solution.field;
  expect_nan_in(field, [&](const auto& broken) { return coefficient_difference(field, broken); });
  expect_nan_in(field, [&](const auto& broken) { return coefficient_difference(broken, field); });
}

TEST(NotANumber, IsInErrorsOfKnownSolutions) {
  const ExactSolution exact{[](const Eigen::Vector3d& x) { return generic_linear_field()(x); },
                            [](const Eigen::Vector3d&) { return generic_linear_field().gradient; }};
  const iga::ElasticField field = two_cubes().solution.field;
  expect_nan_in(field, [&](const auto& broken) { return errors(broken, exact, 3).displacement; });
  expect_nan_in(field, [&](const auto& broken) { return errors(broken, exact, 3).energy; });
}

TEST(NotANumber, IsInJumps) {
  const Solved s = two_cubes();
  expect_nan_in(s.solution.field, [&](const auto& broken) {
    iga::ElasticitySolution solution = s.solution;
    solution.field = broken;
    return largest_jump(s.problem, solution);
  });
}

TEST(NotANumber, IsInMultipliersAndTheirResultants) {
  const Solved s = two_cubes();
  const std::vector<iga::Multiplier>& good = s.solution.multipliers;
  ASSERT_FALSE(good.empty());
  EXPECT_EQ(multiplier_difference(good, good), 0);
  for (std::size_t i = 0; i <= good.size(); ++i) {
    std::vector<iga::Multiplier> broken = good;
    for (std::size_t k = 0; k < broken.size(); ++k)
      if (i == k || i == good.size()) broken[k].force.setConstant(nan);
    EXPECT_TRUE(std::isnan(multiplier_difference(good, broken))) << i;
    EXPECT_TRUE(std::isnan(multiplier_difference(broken, good))) << i;
    const Resultant r = resultant(s.problem, node_forces(s.problem, broken), {PatchId(0)});
    EXPECT_TRUE(std::isnan(r.force.norm()) && std::isnan(r.moment.norm())) << i;
  }
  EXPECT_TRUE(std::isnan(multiplier_difference({}, {}))) << "no multipliers at all";
}

}  // namespace
}  // namespace isopatch::verification
