#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "solvers/scaled_system.hpp"

namespace isopatch::solvers {

/// Solves with the factors of a ScaledSystem's matrix.
using ApplyInverse = std::function<Eigen::VectorXd(const Eigen::VectorXd& right_side)>;

struct RefinedSolution {
  Eigen::VectorXd z;            ///< unknowns and scaled multipliers
  std::vector<double> history;  ///< relative residual of the direct solution, then after each step
};

/// Solves and refines with residuals in extended precision until the tolerance is reached or steps stop
/// helping.
///
/// At least one step is always taken: it removes the error of the factorization up to conditions of about
/// 1e15, so that different factorizations of one matrix agree.
///
/// @throws Error singular_system  if the factors give values that are not finite
/// @cost    one solve and one product with the matrix a step, at most 10 steps
/// @source  Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 12.1
RefinedSolution solve_and_refine(const ScaledSystem& system, const ApplyInverse& inverse, double tolerance);

}  // namespace isopatch::solvers
