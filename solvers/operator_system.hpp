#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "geometry/base/progress.hpp"
#include "solvers/linear_operator.hpp"
#include "solvers/linear_system.hpp"
#include "solvers/shared_rows.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// What it took to make an operator and its preconditioner, for the report.
struct OperatorCosts {
  Operator form = Operator::matrix_free;  ///< whether a matrix is stored
  int levels = 0;                         ///< of a multigrid
  std::int64_t matrix_nonzeros = 0;
  std::int64_t bytes = 0;  ///< of matrix and preconditioner
  double assembly_seconds = 0;
  double setup_seconds = 0;  ///< of the preconditioner
};

/// A symmetric system that is known by its product alone, spread over processes. All vectors are consistent
/// local ones.
struct OperatorSystem {
  SharedRows rows;
  VectorsOperator product;  ///< A
  VectorsOperator
      preconditioner;    ///< symmetric positive definite, near the inverse of A (of |A| if indefinite)
  Eigen::VectorXd load;  ///< b
  OperatorCosts costs = {};
};

/// What is known of a system before it is solved.
SolveReport first_report(const OperatorSystem& system, Method method);

/// Solves A x = b by preconditioned conjugate gradients (A positive definite).
///
/// The error is measured in the norm that the preconditioner M gives, sqrt(r.Mr / b.Mb), about the relative
/// error in energy: unlike ||r|| / ||b|| it does not depend on units, nor on how badly single elements are
/// shaped. Starts again from the true residual where the updated one has drifted from it.
///
/// @throws Error singular_system  a direction without positive energy
/// @throws Error not_converged    with the error reached and advice
/// @cost   one product and one preconditioner an iteration, five vectors
/// @source Hestenes, Stiefel 1952, through PETSc's KSPCG
LinearSolution solve_with_cg(const OperatorSystem& system, const SolverOptions& options,
                             const Progress& progress);

/// The same for a symmetric indefinite A, by minimal residuals.
/// @source Paige, Saunders 1975, through PETSc's KSPMINRES
LinearSolution solve_with_minres(const OperatorSystem& system, const SolverOptions& options,
                                 const Progress& progress);

}  // namespace isopatch::solvers
