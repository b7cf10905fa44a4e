// Condition numbers of the two systems, reported: by Lanczos' method on isopatch's own products and
// solutions, against all eigenvalues of the dense matrix.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <functional>
#include <random>

#include "solvers/solve.hpp"
#include "verification/claims/claim.hpp"
#include "verification/suites/dense_systems.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

// Largest |eigenvalue| of a symmetric operator, by Lanczos' method with all directions kept orthogonal.
double largest_eigenvalue(const Operator& apply, Eigen::Index size, Eigen::Index steps) {
  std::mt19937 random(8);
  std::normal_distribution<double> number;
  Eigen::MatrixXd basis(size, steps);
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(steps, steps);
  Eigen::VectorXd next = Eigen::VectorXd::NullaryExpr(size, [&] { return number(random); });
  Eigen::Index k = 0;
  // Few steps are all there are where few eigenvalues differ.
  for (; k < steps && (k == 0 || next.norm() > 1e-10 * std::abs(projected(0, 0))); ++k) {
    if (k > 0) projected(k, k - 1) = projected(k - 1, k) = next.norm();
    basis.col(k) = next.normalized();
    next = apply(basis.col(k));
    projected(k, k) = basis.col(k).dot(next);
    for (int pass = 0; pass < 2; ++pass)
      next -= basis.leftCols(k + 1) * (basis.leftCols(k + 1).transpose() * next);
  }
  return sorted_eigenvalues(projected.topLeftCorner(k, k)).cwiseAbs().maxCoeff();
}

// [[K, s B^T], [s B, 0]] times (x, y).
Eigen::VectorXd product(const solvers::LinearSystem& system, double scale, const Eigen::VectorXd& z) {
  const Eigen::Index n = system.stiffness.rows();
  Eigen::VectorXd result(z.size());
  result.head(n) = solvers::multiply(system.stiffness, z.head(n));
  if (!system.has_constraints()) return result;
  result.head(n) += scale * (system.constraints.transpose() * z.tail(z.size() - n));
  result.tail(z.size() - n) = scale * (system.constraints * z.head(n));
  return result;
}

// Its inverse, by isopatch's solver, which knows no right side for the constraints: what satisfies them is
// taken off first.
Eigen::VectorXd solution(solvers::LinearSystem& system, double scale, const Eigen::VectorXd& z) {
  const Eigen::Index n = system.stiffness.rows();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(z.size());
  system.load = z.head(n);
  if (system.has_constraints()) {
    const Eigen::SparseMatrix<double> transposed = system.constraints.transpose();
    const Eigen::SparseMatrix<double> gram = transposed.transpose() * transposed;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(gram);
    result.head(n) = transposed * factors.solve(z.tail(z.size() - n)) / scale;
    system.load -= solvers::multiply(system.stiffness, result.head(n));
  }
  const solvers::LinearSolution solved = solvers::solve(system);
  result.head(n) += solved.x;
  if (system.has_constraints()) result.tail(z.size() - n) = solved.multipliers / scale;
  return result;
}

void expect_condition(const ModelCase& model, iga::Coupling coupling) {
  std::vector<std::string> overrides = pulled_overrides(model);
  overrides.insert(overrides.end(), {"discretization.degree=1", "discretization.refine=0",
                                     fmt::format("coupling.method={}", iga::name(coupling))});
  const SolvedStudy s = solved("verification/studies/pulled.toml", overrides);
  solvers::LinearSystem system = system_of(s.run.built.problem, coupling);
  const double scale = solvers::mean_diagonal(system.stiffness);
  const Eigen::VectorXd eigenvalues = sorted_eigenvalues(dense(system)).cwiseAbs();
  const Eigen::Index size = eigenvalues.size();
  const double largest =
      largest_eigenvalue([&](const auto& z) { return product(system, scale, z); }, size, 100);
  const double smallest =
      1 / largest_eigenvalue([&](const auto& z) { return solution(system, scale, z); }, size, 60);
  expect(Claim{fmt::format("{} as it is, {}: condition number", model.name, iga::name(coupling)), "",
               ReferenceKind::other_method, "all eigenvalues of the dense matrix",
               eigenvalues[size - 1] / eigenvalues[0], largest / smallest, 1e-4, s.named});
}

TEST(Coupling, ConditionOfBothSystems) {
  for (const ModelCase& model : model_cases())
    for (const iga::Coupling coupling : {iga::Coupling::elimination, iga::Coupling::lagrange})
      expect_condition(model, coupling);
}

}  // namespace
}  // namespace isopatch::verification
