#pragma once

#include <string_view>

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

/// The preconditioner of iterative methods. A multigrid needs to know where the matrix comes from: `solve`
/// itself has block Jacobi alone, and wants it named.
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
  bool operator==(const SolverOptions&) const = default;
};
/// @throws Error invalid_argument naming field, value and range
void validate(const SolverOptions& options);

}  // namespace isopatch::solvers
