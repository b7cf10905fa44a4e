#pragma once

#include <Eigen/Core>
#include <functional>

#include "solvers/internal/krylov.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// What an iteration that starts again from the true residual needs to know.
struct RestartedProblem {
  const SharedRows& rows;
  LinearOperator product;
  LinearOperator preconditioner;
  LinearOperator residual;                              ///< b - A x, computed afresh
  std::function<double(const Eigen::VectorXd&)> error;  ///< of a residual, relative to that of x = 0
  Krylov method = Krylov::conjugate_gradients;
  ErrorNorm norm = ErrorNorm::residual;
  /// Share of the tolerance to iterate to, for the true residual is not quite the updated one.
  double margin = 1;
};

struct RestartedSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd residual;  ///< true
  double error = 0;
};

/// Iterates from x = 0, and starts again from the true residual as long as that brings the error down. Fills
/// in iterations and residual history of the report. Does not throw where it does not converge.
/// @param right_side  b
/// @param error       of x = 0: 1, or 0 if there is nothing to solve
/// @throws Error singular_system  a direction without positive energy
RestartedSolution iterate_with_restarts(const RestartedProblem& problem, const Eigen::VectorXd& right_side,
                                        double error, const SolverOptions& options, const Progress& progress,
                                        SolveReport& report);

}  // namespace isopatch::solvers
