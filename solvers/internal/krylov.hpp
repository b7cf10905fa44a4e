#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/internal/petsc_objects.hpp"
#include "solvers/linear_operator.hpp"
#include "solvers/shared_rows.hpp"

namespace isopatch::solvers {

enum class Krylov { conjugate_gradients, minimal_residuals };

/// In which norm the error is measured.
enum class ErrorNorm {
  residual,        ///< ||r||; conjugate gradients only
  preconditioned,  ///< sqrt(r.Mr)
};

struct KrylovOptions {
  Krylov method = Krylov::conjugate_gradients;
  ErrorNorm norm = ErrorNorm::residual;
  double reduction = 0;  ///< of the error's norm at which to stop
  int max_iterations = 0;
};

struct KrylovSolution {
  Eigen::VectorXd x;  ///< consistent local vector
  /// Before the first iteration (1) and after each, relative to the start, as updated recursively.
  std::vector<double> errors;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
};

/// Iterates from x = 0. Operators and right side live on consistent local vectors, PETSc's vectors on the
/// rows that each process owns. Does not throw where it does not converge: `reason` says how it ended.
KrylovSolution iterate(const SharedRows& rows, const LinearOperator& product,
                       const LinearOperator& preconditioner, const Eigen::VectorXd& right_side,
                       const KrylovOptions& options, const Progress& progress);

}  // namespace isopatch::solvers
