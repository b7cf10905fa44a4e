#include "verification/suites/dense_systems.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "iga/solution/assembled_system.hpp"

namespace isopatch::verification {

solvers::LinearSystem system_of(const iga::ElasticityProblem& problem, iga::Coupling coupling) {
  const iga::CoupledProblem coupled = iga::coupled_problem(problem, {.coupling = coupling});
  return iga::assembled_system(coupled).system;
}

Eigen::MatrixXd dense(const solvers::SymmetricBlockMatrix& matrix) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.rows(), matrix.rows());
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (std::int64_t k = matrix.row_start[static_cast<std::size_t>(row)];
         k < matrix.row_start[static_cast<std::size_t>(row) + 1]; ++k) {
      const int column = matrix.columns[static_cast<std::size_t>(k)];
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> block(
          &matrix.values[static_cast<std::size_t>(9 * k)]);
      result.block<3, 3>(3 * row, 3 * column) = block;
      result.block<3, 3>(3 * column, 3 * row) = block.transpose();
    }
  return result;
}

Eigen::MatrixXd dense(const solvers::LinearSystem& system) {
  const Eigen::Index n = system.stiffness.rows(), m = system.constraints.rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n + m, n + m);
  result.topLeftCorner(n, n) = dense(system.stiffness);
  if (m == 0) return result;
  const Eigen::MatrixXd scaled =
      solvers::mean_diagonal(system.stiffness) * Eigen::MatrixXd(system.constraints);
  result.bottomLeftCorner(m, n) = scaled;
  result.topRightCorner(n, m) = scaled.transpose();
  return result;
}

Eigen::VectorXd sorted_eigenvalues(const Eigen::MatrixXd& symmetric) {
  Eigen::VectorXd values = symmetric_eigenvalues(symmetric);
  std::sort(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return values;
}

}  // namespace isopatch::verification
