#pragma once

#include <Eigen/Core>

#include "iga/solution/solve_elasticity.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::verification {

/// The equations of a problem as the program hands them to its solvers: K x + B^T y = f, B x = 0, supports
/// brought in, B without rows for elimination. Loads are left at 0.
solvers::LinearSystem system_of(const iga::ElasticityProblem& problem, iga::Coupling coupling);

/// Both triangles. (rows, rows)
Eigen::MatrixXd dense(const solvers::SymmetricBlockMatrix& matrix);

/// [[K, s B^T], [s B, 0]] with s the mean of K's diagonal, which is what is factorized; K alone without
/// constraints.
Eigen::MatrixXd dense(const solvers::LinearSystem& system);

/// Eigenvalues by size of their absolute value, increasing.
/// @cost  O(n^3)
Eigen::VectorXd sorted_eigenvalues(const Eigen::MatrixXd& symmetric);

}  // namespace isopatch::verification
