#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/linear_system.hpp"
#include "solvers/multigrid_options.hpp"

namespace isopatch::solvers {

/// Ways to solve a LinearSystem.
enum class Method {
  automatic,  ///< left to who knows where the system comes from; `solve` refuses it
  cholmod,    ///< supernodal Cholesky with METIS ordering; no constraints
  mumps,      ///< LDL^T with pivoting; with or without constraints
  umfpack,    ///< LU with pivoting; fallback for both
  cg,         ///< conjugate gradients; no constraints
  minres,     ///< minimal residuals; with constraints, and only where a multigrid is at hand
};
/// "auto", "cholmod", "mumps", "umfpack", "cg", "minres".
std::string_view name(Method method);

/// What makes iterative methods fast. A multigrid needs to know where the matrix comes from: `solve` itself
/// has block Jacobi alone.
enum class Preconditioner { multigrid, block_jacobi };
std::string_view name(Preconditioner preconditioner);

/// Whether iterative methods store a matrix or compute its product anew each time.
enum class Operator { automatic, assembled, matrix_free };
std::string_view name(Operator form);

struct SolverOptions {
  Method method = Method::automatic;
  /// Relative residual to reach. Range [1e-14, 1e-2]. Direct methods refine until it is reached and fail
  /// if they cannot, unless rounding the solution to doubles alone leaves as much (then `reason` says so).
  double tolerance = 1e-10;
  /// For iterative methods. Range 1 .. 10^7.
  int max_iterations = 10000;
  Preconditioner preconditioner = Preconditioner::multigrid;
  Operator form = Operator::automatic;
  MultigridOptions multigrid = {};
  /// Bytes that the run may use; 0: what the machine has to spare.
  double memory_limit = 0;
};
/// @throws Error invalid_argument naming field, value and range
void validate(const SolverOptions& options);

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
  double assembly_seconds = 0;    ///< of an iterative method's matrix
  double analysis_seconds = 0;    ///< ordering and symbolic factorization, or preconditioner set-up
  double factorization_seconds = 0;
  double solve_seconds = 0;
};

struct LinearSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers;  ///< y, empty without constraints
  SolveReport report;
};

/// Solves a linear system by the method that the options name.
///
/// @throws Error invalid_argument  options out of range, no method named or one that cannot treat the system
/// @throws Error singular_system   a zero or negative pivot, saying at which block row
/// @throws Error not_converged     with the residual reached and advice
/// @throws Error out_of_memory     with the memory that was asked for where the library says it
LinearSolution solve(const LinearSystem& system, const SolverOptions& options = {},
                     const Progress& progress = {});

}  // namespace isopatch::solvers
