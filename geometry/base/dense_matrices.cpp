#include "geometry/base/dense_matrices.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <limits>

namespace isopatch {
namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

SymmetricEigen result_of(const Solver& solver) {
  if (solver.info() == Eigen::Success) return {solver.eigenvalues(), solver.eigenvectors()};
  const Eigen::Index n = solver.eigenvalues().size();
  return {Eigen::VectorXd::Constant(n, nan), Eigen::MatrixXd::Constant(n, n, nan)};
}

}  // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
  return result_of(Solver(matrix));
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& mass) {
  return result_of(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, mass));
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  const Solver solver(matrix, Eigen::EigenvaluesOnly);
  if (solver.info() == Eigen::Success) return solver.eigenvalues();
  return Eigen::VectorXd::Constant(matrix.rows(), nan);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace isopatch
