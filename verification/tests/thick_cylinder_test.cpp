// Lame's thick-walled cylinder under inner pressure, plane strain: a closed form on an exact rational
// geometry. a = 1, b = 2, E = 1000, nu = 0.3, p = 10; two patches across the wall and two around.

#include <gtest/gtest.h>

#include "geometry/models/cylinder.hpp"
#include "iga/element.hpp"
#include "iga/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"
#include "verification/tests/expect_order.hpp"

namespace isopatch::verification {
namespace {

using iga::testing::boundary;

constexpr double nu = 0.3;
constexpr double factor = (1 + nu) / 1000 * 10.0 / 3;  // (1 + nu) / E p a^2 / (b^2 - a^2)

Eigen::Vector3d exact_displacement(const Eigen::Vector3d& x) {
  const Eigen::Vector3d in_plane(x[0], x[1], 0);
  return factor * ((1 - 2 * nu) + 4 / in_plane.squaredNorm()) * in_plane;
}

Eigen::Matrix3d exact_gradient(const Eigen::Vector3d& x) {
  const Eigen::Vector3d r(x[0], x[1], 0);
  Eigen::Matrix3d plane = Eigen::Vector3d(1, 1, 0).asDiagonal();
  return factor * (((1 - 2 * nu) + 4 / r.squaredNorm()) * plane -
                   8 / (r.squaredNorm() * r.squaredNorm()) * r * r.transpose());
}

struct Errors {
  double displacement = 0;  ///< in L2, relative
  double gradient = 0;      ///< in L2, relative: equivalent to the energy norm
};

Errors errors(const iga::ElasticField& field) {
  Eigen::Array4d sums = Eigen::Array4d::Zero();
  iga::ElementValues values;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const iga::ElementEvaluator evaluator(field.patches[p], field.patches[p].degree(0) + 4);
    for (std::int64_t e = 0; e < evaluator.element_count(); ++e) {
      evaluator.evaluate(e, values);
      Eigen::Matrix3Xd u(3, static_cast<Eigen::Index>(values.functions.size()));
      for (Eigen::Index a = 0; a < u.cols(); ++a)
        u.col(a) = field.displacement[p].col(values.functions[static_cast<std::size_t>(a)]);
      for (Eigen::Index q = 0; q < values.measures.size(); ++q) {
        Eigen::Matrix3d gradient;
        for (int j = 0; j < 3; ++j)
          gradient.col(j) = u * values.gradients[static_cast<std::size_t>(j)].col(q);
        const Eigen::Vector3d place = values.places.col(q);
        sums += values.measures[q] *
                Eigen::Array4d((u * values.values.col(q) - exact_displacement(place)).squaredNorm(),
                               exact_displacement(place).squaredNorm(),
                               (gradient - exact_gradient(place)).squaredNorm(),
                               exact_gradient(place).squaredNorm());
      }
    }
  }
  return {std::sqrt(sums[0] / sums[1]), std::sqrt(sums[2] / sums[3])};
}

class ThickCylinder : public ::testing::TestWithParam<std::tuple<int, iga::Coupling>> {};

TEST_P(ThickCylinder, ConvergesWithTheFullOrder) {
  const auto [degree, coupling] = GetParam();
  const geometry::MultiPatch model =
      geometry::connect(geometry::cylinder_model({.radial_patches = 2, .patches_around = 2}));
  // Around, the exact solution lies in the space; 8 points integrate the rational maps below the finest
  // error.
  std::vector<double> sizes, displacement, gradient;
  for (const int elements : {8, 16, 32, 64}) {
    iga::ElasticityProblem problem =
        iga::testing::problem(model, {.degree = {degree, 2, 1}, .elements_per_direction = {elements, 0, 0}},
                              iga::isotropic(1000, nu));
    for (const char* plane : {"start", "end", "bottom", "top"})
      problem.supports.push_back({plane, boundary(model, plane), iga::PlaneSupport{}});
    problem.surface_loads = {iga::pressure_load("pressure", boundary(model, "inner"), 10)};
    const Errors e =
        errors(iga::solve_elasticity(problem, {.coupling = coupling, .quadrature_points = 8}).field);
    sizes.push_back(1.0 / elements);
    displacement.push_back(e.displacement);
    gradient.push_back(e.gradient);
  }
  expect_order(sizes, displacement, degree + 1, 0.15);
  expect_order(sizes, gradient, degree, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Degrees, ThickCylinder,
                         ::testing::Combine(::testing::Values(1, 2, 3),
                                            ::testing::Values(iga::Coupling::elimination,
                                                              iga::Coupling::lagrange)));

TEST(ThickCylinderEnergy, IsTheClosedFormAtTwoRatios) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::cylinder_model({.radial_patches = 2, .patches_around = 2}));
  for (const auto& [ratio, energy] : {std::pair{0.3, 0.07487462}, std::pair{0.4999, 0.07853851}}) {
    iga::ElasticityProblem problem = iga::testing::problem(
        model, {.degree = {4, 4, 1}, .elements_per_direction = {6, 2, 0}}, iga::isotropic(1000, ratio));
    for (const char* plane : {"start", "end", "bottom", "top"})
      problem.supports.push_back({plane, boundary(model, plane), iga::PlaneSupport{}});
    problem.surface_loads = {iga::pressure_load("pressure", boundary(model, "inner"), 10)};
    EXPECT_NEAR(iga::solve_elasticity(problem).results.internal_energy / energy, 1, 1e-6) << ratio;
  }
}

}  // namespace
}  // namespace isopatch::verification
