#include "solvers/condition.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "solvers/block_product.hpp"
#include "solvers/solve.hpp"

namespace isopatch::solvers {
namespace {

constexpr int steps_of_products = 60;
constexpr int steps_of_solutions = 30;

Eigen::VectorXd random_start(Eigen::Index size) {
  std::mt19937 random(8);
  std::normal_distribution<double> number;
  return Eigen::VectorXd::NullaryExpr(size, [&] { return number(random); });
}

// Largest |eigenvalue| of a symmetric operator; all directions are kept orthogonal.
double largest_eigenvalue(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                          Eigen::Index size, int most_steps) {
  const Eigen::Index steps = std::min<Eigen::Index>(size, most_steps);
  Eigen::MatrixXd basis(size, steps);
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(steps, steps);
  Eigen::VectorXd next = random_start(size);
  Eigen::Index k = 0;
  double scale = 0;
  // Few steps are all there are where few eigenvalues differ.
  for (; k < steps && (k == 0 || next.norm() > 1e-10 * scale); ++k) {
    if (k > 0) projected(k, k - 1) = projected(k - 1, k) = next.norm();
    basis.col(k) = next.normalized();
    next = apply(basis.col(k));
    scale = std::max(scale, next.norm());
    projected(k, k) = basis.col(k).dot(next);
    for (int pass = 0; pass < 2; ++pass)
      next -= basis.leftCols(k + 1) * (basis.leftCols(k + 1).transpose() * next);
  }
  return symmetric_eigenvalues(projected.topLeftCorner(k, k)).cwiseAbs().maxCoeff();
}

}  // namespace

ConditionEstimate estimate_condition(const LinearSystem& system, const Progress& progress) {
  if (system.rows.is_distributed())
    throw Error(ErrorCode::unsupported, "condition numbers are estimated on one process only");
  const Eigen::Index n = system.stiffness.rows();
  const double scale = mean_diagonal(system.stiffness);
  const auto product = [&](const Eigen::VectorXd& z) {
    Eigen::VectorXd result(z.size());
    result.head(n) = multiply(system.stiffness, z.head(n));
    if (system.has_constraints()) {
      result.head(n) += scale * (system.constraints.transpose() * z.tail(z.size() - n));
      result.tail(z.size() - n) = scale * (system.constraints * z.head(n));
    }
    return result;
  };
  LinearSystem loaded = system;
  // `solve` knows no right side of the constraints: what satisfies it, orthogonal to their kernel, is taken
  // off first.
  const Eigen::SparseMatrix<double> transposed = system.constraints.transpose();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> gram(
      Eigen::SparseMatrix<double>(transposed.transpose() * transposed));
  const auto solution = [&](const Eigen::VectorXd& z) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(z.size());
    loaded.load = z.head(n);
    if (system.has_constraints()) {
      result.head(n) = transposed * gram.solve(z.tail(z.size() - n)) / scale;
      loaded.load -= multiply(system.stiffness, result.head(n));
    }
    const LinearSolution found =
        solve(loaded, {.method = system.has_constraints() ? Method::mumps : Method::cholmod});
    result.head(n) += found.x;
    if (system.has_constraints()) result.tail(z.size() - n) = found.multipliers / scale;
    return result;
  };
  progress("estimating the condition", 0);
  ConditionEstimate estimate;
  estimate.largest = largest_eigenvalue(product, n + system.constraints.rows(), steps_of_products);
  estimate.smallest = 1 / largest_eigenvalue(solution, n + system.constraints.rows(), steps_of_solutions);
  return estimate;
}

}  // namespace isopatch::solvers
