#include "verification/suites/known_problem.hpp"

#include <fmt/format.h>

namespace isopatch::verification {
namespace {

iga::ElasticityOptions options(const KnownProblem& problem, const Levels& levels) {
  iga::ElasticityOptions result{.coupling = levels.coupling,
                                .non_matching = levels.non_matching,
                                .quadrature_points = problem.points > 0 ? problem.points : levels.degree + 2};
  const bool eliminates = levels.coupling == iga::Coupling::elimination &&
                          levels.non_matching == iga::NonMatchingCoupling::nitsche;
  // Errors of high degrees are below what iterations are asked for by default.
  result.solver.method = eliminates ? solvers::Method::cholmod : solvers::Method::mumps;
  if (!levels.iterate) return result;
  result.solver.method =
      levels.coupling == iga::Coupling::elimination ? solvers::Method::cg : solvers::Method::minres;
  result.solver.tolerance = 1e-12;
  return result;
}

}  // namespace

void expect_orders(const KnownProblem& problem, const Levels& levels) {
  const std::string of =
      fmt::format("{}, p = {}, {}{}", problem.name, levels.degree, iga::name(levels.coupling),
                  levels.non_matching == iga::NonMatchingCoupling::mortar ? " and mortar" : "");
  Convergence displacement{.what = "displacement in L2, " + of,
                           .kind = problem.kind,
                           .source = problem.source.empty() ? "p + 1" : problem.source + ", p + 1",
                           .order = levels.degree + 1.0};
  Convergence energy{.what = "energy norm, " + of,
                     .kind = problem.kind,
                     .source = problem.source.empty() ? "p" : problem.source + ", p",
                     .order = static_cast<double>(levels.degree)};
  for (const int elements : levels.elements) {
    const iga::ElasticitySolution solution =
        iga::solve_elasticity(problem.posed(levels.degree, elements), options(problem, levels));
    const Errors e = errors(solution.field, problem.exact, levels.degree + 4);
    for (Convergence* claim : {&displacement, &energy}) claim->sizes.push_back(1.0 / elements);
    displacement.errors.push_back(e.displacement);
    energy.errors.push_back(e.energy);
  }
  expect(displacement);
  expect(energy);
}

iga::ElasticityProblem unloaded(const geometry::MultiPatch& model, const iga::DiscretizationOptions& options,
                                const iga::Material& material) {
  return {iga::discretize(model, options),
          std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), material),
          {},
          {},
          {}};
}

iga::SurfaceLoad exact_tractions(std::vector<geometry::PatchFace> faces, const ExactSolution& exact,
                                 const iga::Material& material) {
  return {"exact tractions", std::move(faces),
          [=](const Eigen::Vector3d& x, const Eigen::Vector3d& n) -> Eigen::Vector3d {
            return stress_of(exact.gradient(x), material) * n;
          }};
}

}  // namespace isopatch::verification
