#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

struct SolveReport {
  Method method = Method::automatic;  ///< the one used, never automatic
  std::string reason;  ///< why this method, and what was tried before it; from `solve` only why not exacter
  int iterations = 0;  ///< Krylov iterations, or steps of iterative refinement of a direct method
  /// ||(f - K x - B^T y, s B x)|| / ||f||, computed afresh at the end; s is the mean of |diag K|, which turns
  /// the constraints' error into a force.
  double relative_residual = 0;
  /// With a multigrid: the relative error in the preconditioner's norm, about the relative error in energy.
  double energy_error = 0;
  /// Relative residual after each iteration, the start first; with a multigrid in the norm of energy_error.
  std::vector<double> residual_history;
  Operator form = Operator::assembled;  ///< whether a matrix was stored
  int levels = 0;                       ///< of the multigrid
  std::int64_t matrix_nonzeros = 0;
  std::int64_t factor_nonzeros = 0;  ///< 0 for iterative methods
  double factor_flops = 0;
  std::int64_t memory_bytes = 0;  ///< held by the solver at its peak, as it reports itself
  double assembly_seconds = 0;    ///< of the matrix
  double analysis_seconds = 0;    ///< ordering and symbolic factorization, or preconditioner set-up
  double factorization_seconds = 0;
  double solve_seconds = 0;
};

struct LinearSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers;  ///< y, empty without constraints
  SolveReport report;
};

}  // namespace isopatch::solvers
