#include "geometry/base/dense_matrices.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
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

SymmetricEigen tridiagonal_eigen(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside) {
  Solver solver;
  solver.computeFromTridiagonal(diagonal, beside);
  return result_of(solver);
}

PrincipalAxes principal_axes(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  if (solver.info() == Eigen::Success) return {solver.eigenvalues(), solver.eigenvectors()};
  return {Eigen::Vector3d::Constant(nan), Eigen::Matrix3d::Constant(nan)};
}

LeftSingular left_singular(const Eigen::MatrixXd& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(matrix, Eigen::ComputeFullU);
  return {parts.singularValues(), parts.matrixU()};
}

Eigen::VectorXd solve_semidefinite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::LDLT<Eigen::MatrixXd> factors(matrix);
  if (factors.info() != Eigen::Success) return Eigen::VectorXd::Constant(right.size(), nan);
  return factors.solve(right);
}

Eigen::MatrixXd solve_by_lu(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace isopatch
