#include "iga/solution/planned_solution.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/error.hpp"
#include "iga/solution/likely_cause.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;
using ::testing::AllOf;
using testing::boundary;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::problem;

const Material soft_steel = isotropic(200e9, 0.3, 7850, "steel");

/// A sheet of 1 m x 1 m, clamped all round, under 1 Pa.
ElasticityProblem sheet(double thickness, const Material& material = soft_steel) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {1, 1, thickness}, .patches = {2, 2, 1}}));
  ElasticityProblem p = problem(model, {.degree = {4, 4, 4}, .elements_per_direction = {4, 4, 1}}, material);
  for (const char* side : {"x_min", "x_max", "y_min", "y_max"})
    p.supports.push_back({side, boundary(model, side), PrescribedDisplacement{}});
  p.surface_loads = {pressure_load("wind", boundary(model, "z_max"), 1)};
  return p;
}

// Deflection of a clamped square plate: 0.00126532 q a^4 / D (Timoshenko, Woinowsky-Krieger, table 35).
double kirchhoff(double thickness) {
  return 0.00126532 * 12 * (1 - 0.3 * 0.3) / (200e9 * std::pow(thickness, 3));
}

TEST(PlannedSolution, ThinSheetsAreSolvedByWhatWorks) {
  for (const double thickness : {1e-3, 1e-4}) {
    const ElasticitySolution s = solve_elasticity(sheet(thickness));
    // These elements leave 1.6 and 1.8 % of the deflection.
    EXPECT_NEAR(s.results.max_displacement.value / kirchhoff(thickness), 1, 0.03) << thickness;
    EXPECT_NEAR(s.results.external_work / s.results.internal_energy, 1, 1e-9) << thickness;
    EXPECT_EQ(s.solver.method, Method::cg);
    EXPECT_THAT(s.solver.reason, AllOf(HasSubstr("cholmod failed: "), HasSubstr("; so iterations")))
        << thickness;
    EXPECT_GE(s.predicted_bytes, s.solver.memory_bytes);
  }
}

std::string failure(const ElasticityProblem& p, const ElasticityOptions& options) {
  try {
    solve_elasticity(p, options);
  } catch (const Error& error) {
    return fmt::format("{}: {}", isopatch::name(error.code()), error.what());
  }
  return "nothing was thrown";
}

TEST(PlannedSolution, TooFewGaussPointsAreNamedAndNotARigidMotion) {
  const std::string message = failure(sheet(0.1), {.quadrature_points = 1});
  EXPECT_THAT(message, AllOf(HasSubstr("singular_system"),
                             HasSubstr("1 Gauss point per direction is too few for degree 4"),
                             Not(HasSubstr("rigid")), Not(HasSubstr("hardly held"))));
}

TEST(LikelyCause, NamesPoissonsRatioMaterialsAndThinPatches) {
  EXPECT_THAT(likely_cause(sheet(0.1, isotropic(1e9, 0.4999999)), 0),
              AllOf(HasSubstr("Poisson's ratio of 0.4999999"), Not(HasSubstr("held"))));
  EXPECT_THAT(likely_cause(sheet(1e-4), 0), HasSubstr("times as long as thick"));
  ElasticityProblem mixed = sheet(0.1);
  mixed.materials[1] = isotropic(200, 0.3);  // GPa without its unit
  EXPECT_THAT(likely_cause(mixed, 0), HasSubstr("Young's modulus 1e+09 times"));
  EXPECT_THAT(likely_cause(sheet(0.1), 0), HasSubstr("few points only"));
  EXPECT_THAT(likely_cause(sheet(0.1), 3),
              HasSubstr("3 Gauss points per direction are too few for degree 4"));
}

}  // namespace
}  // namespace isopatch::iga
