// The estimate of the discretization's error against the error itself: their ratio is the effectivity.

#include "iga/estimate/error_estimate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/suites/known_problems.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

using iga::Coupling;

// Effectivities that an estimate may have where the solution is smooth, and where it is not.
struct Range {
  double least;
  double most;
};
constexpr Range smooth{0.7, 1.5};
constexpr Range at_reentrant_edges{0.5, 2};

void expect_effectivity(const std::string& of, ReferenceKind kind, const std::string& source, double value,
                        const Range& range, const ClaimStudy& study = {}) {
  expect(Claim{.what = "effectivity of the error estimate, " + of,
               .kind = kind,
               .source = source,
               .reference = range.most,
               .value = value,
               .study = study,
               .comparison = Comparison::at_most,
               .least = range.least});
}

void expect_effectivity(const KnownProblem& problem, int degree, int elements,
                        Coupling coupling = Coupling::elimination) {
  const iga::ElasticityProblem posed = problem.posed(degree, elements);
  const iga::ElasticityOptions options{.coupling = coupling, .quadrature_points = problem.points};
  const iga::ElasticitySolution solution = iga::solve_elasticity(posed, options);
  const double found = iga::estimate_error(posed, solution.field, {}, options).relative;
  expect_effectivity(fmt::format("{}, p = {}, {} {} a direction, {}", problem.name, degree, elements,
                                 elements == 1 ? "element" : "elements", iga::name(coupling)),
                     problem.kind, problem.source,
                     found / errors(solution.field, problem.exact, degree + 4).energy, smooth);
}

TEST(ErrorEstimate, Manufactured) {
  for (const int degree : {1, 2, 3, 4})
    for (const int elements : {1, 2, 4}) {
      expect_effectivity(one_patch(degree), degree, elements);
      expect_effectivity(eight_patches(degree), degree, elements);
    }
  for (const int degree : {1, 2, 3})
    for (const int elements : {2, 4, 8}) {
      expect_effectivity(wedge(), degree, elements);
      expect_effectivity(manufactured_cylinder(), degree, elements);
    }
  expect_effectivity(eight_patches(2), 2, 4, Coupling::lagrange);
}

TEST(ErrorEstimate, ClosedForms) {
  for (const int degree : {1, 2, 3})
    for (const int elements : {1, 2, 4, 8}) expect_effectivity(pressed_tube(), degree, elements);
  for (const int degree : {2, 3, 4})
    for (const int elements : {1, 2, 4, 8})
      expect_effectivity(plate_with_hole(iga::isotropic(1000, 0.3)), degree, elements);
  for (const int elements : {1, 2})
    expect_effectivity(body_with_cavity(iga::isotropic(1000, 0.3)), 4, elements);
  expect_effectivity(pressed_tube(), 2, 4, Coupling::lagrange);
}

// Where supports do no work the solution's energy is too small by that of its error.
void expect_effectivity_of_study(const std::string& file, const std::vector<std::string>& overrides,
                                 const std::string& of, double energy, const std::string& source,
                                 const Range& range) {
  const SolvedStudy s = solved(file, overrides);
  const double error = energy - s.run.solution.results.internal_energy;
  expect_effectivity(of, ReferenceKind::other_method, source, std::sqrt(s.run.error->energy / error), range,
                     s.named);
}

// Both limits from p = 3 and 4 on three levels each, extrapolated with the singularity's own exponent
// 2 * 0.5445; they differ in the fifth digit.
TEST(ErrorEstimate, ReentrantEdge) {
  constexpr double limit = 0.0238563;
  for (const int degree : {1, 2, 3, 4})
    for (const int refine : {1, 2, 3})
      expect_effectivity_of_study(
          "verification/studies/bracket.toml",
          {fmt::format("discretization.degree={}", degree), fmt::format("discretization.refine={}", refine)},
          fmt::format("L-bracket, p = {}, {} elements a direction", degree, 1 << refine), limit,
          "limit of finer meshes", at_reentrant_edges);
}

// Locking is an error of the discretization like others: the estimate sees it.
TEST(ErrorEstimate, NearlyIncompressible) {
  const std::string file = "verification/studies/macneal_cylinder.toml";
  // p / 2 times the displacement of the inner wall, times its area: a quarter, of height 1.
  constexpr double a = 3, b = 9, nu = 0.4999;
  const double wall = (1 + nu) / 1000 * a * a / (b * b - a * a) * ((1 - 2 * nu) * a + b * b / a);
  const double energy = 0.5 * wall * M_PI / 2 * a;
  for (const int degree : {2, 3})
    for (const int refine : {0, 1})
      expect_effectivity_of_study(
          file,
          {fmt::format("discretization.degree={}", degree), fmt::format("discretization.refine={}", refine)},
          fmt::format("MacNeal and Harder's cylinder, nu = 0.4999, p = {}, refine = {}", degree, refine),
          energy, "Lame", smooth);
}

// By how much stress is said to be off, and by how much it is. Errors of stress change their sign in each
// element, so single values say less than norms.
TEST(ErrorEstimate, StressAtAWall) {
  for (const int degree : {2, 3, 4})
    for (const int elements : {2, 4}) {
      const KnownProblem problem = pressed_tube();
      const iga::ElasticityProblem posed = problem.posed(degree, elements);
      const iga::ElasticityOptions options{.quadrature_points = problem.points};
      const iga::ElasticitySolution solution = iga::solve_elasticity(posed, options);
      const Eigen::Vector3d place(1, 0, 0.25);
      const iga::Location wall = iga::locate(solution.field, place);
      const Eigen::Matrix3d stress = iga::evaluate(solution.field, wall.patch, wall.parameter).stress;
      const Eigen::Matrix3d exact = stress_of(problem.exact.gradient(place), posed.materials.front());
      const Eigen::Matrix3d found =
          iga::estimate_error(posed, solution.field, {{wall.patch, wall.parameter}}, options)
              .stress_at.front();
      expect(Claim{.what = fmt::format("estimated over true error of stress at the inner wall, thick "
                                       "cylinder, p = {}, {} elements a direction",
                                       degree, elements),
                   .source = "Lame",
                   .reference = 2,
                   .value = iga::von_mises(found) / iga::von_mises(exact - stress),
                   .comparison = Comparison::at_most,
                   .least = 0.5});
    }
}

}  // namespace
}  // namespace isopatch::verification
