#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/internal/petsc_objects.hpp"

namespace isopatch::solvers {

/// Chooses and configures the preconditioner of a Krylov method.
using ConfigurePreconditioner = std::function<void(PC)>;

struct KrylovOptions {
  double residual = 0;  ///< norm of the residual at which to stop
  int max_iterations = 0;
};

struct KrylovSolution {
  Eigen::VectorXd x;
  std::vector<double> residual_norms;  ///< before the first iteration and after each
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
};

/// Conjugate gradients for a symmetric positive definite PETSc matrix, assembled or a shell, from x = 0 on.
///
/// The norms are those of the recursively updated, unpreconditioned residual. Does not throw where it does
/// not converge: `reason` says how it ended.
///
/// @source Hestenes, Stiefel 1952, through PETSc's KSPCG
KrylovSolution conjugate_gradients(const petsc::Matrix& matrix, const ConfigurePreconditioner& configure,
                                   const Eigen::VectorXd& right_side, const KrylovOptions& options,
                                   const Progress& progress);

}  // namespace isopatch::solvers
