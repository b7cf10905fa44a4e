#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "solvers/scaled_system.hpp"
#include "solvers/solve_report.hpp"

namespace isopatch::solvers {

/// Solves with the factors of a ScaledSystem's matrix, several right sides at once: columns in, columns out.
using ApplyInverse = std::function<Eigen::MatrixXd(const Eigen::MatrixXd& right_sides)>;

struct RefinedSolution {
  Eigen::VectorXd z;            ///< unknowns and scaled multipliers
  std::vector<double> history;  ///< relative residual of the direct solution, then after each step
};

/// Solves and refines with residuals in extended precision until the tolerance is reached or steps stop
/// helping, each right side by itself; the factors are gone through once a step for all of them.
///
/// At least one step is always taken: it removes the error of the factorization up to conditions of about
/// 1e15, so that different factorizations of one matrix agree.
///
/// @param systems  one matrix with one right side or more, none of them zero
/// @return  one solution for each
/// @throws Error singular_system  if the factors give values that are not finite
/// @cost    one solve a step, at most 10 steps, and one product with the matrix a step and right side
/// @source  Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 12.1
std::vector<RefinedSolution> solve_and_refine(const ScaledSystems& systems, const ApplyInverse& inverse,
                                              double tolerance);

/// Solutions of a direct method with a report each: what the factors took, then the right side's own history
/// and its share of the time.
/// @param report  of the factors
std::vector<LinearSolution> with_reports(const ScaledSystems& systems, std::vector<RefinedSolution> refined,
                                         const SolveReport& report, double solve_seconds);

}  // namespace isopatch::solvers
