#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::solvers {

/// Solutions of several loads, with their errors before the first iteration (1) and after each, as updated.
struct BlockSolution {
  Eigen::MatrixXd x;
  std::vector<std::vector<double>> errors;
};

/// Solves A x = b by preconditioned conjugate gradients for several loads at once: the directions of all
/// serve each of them, so that fewer iterations are needed than for one load after the other.
///
/// Directions are made orthonormal in A at every step, and those that depend on others are dropped; a load
/// whose error is small enough adds none. Errors are measured as in `solve_with_cg`, but by updated
/// residuals: the true ones are the caller's to look at, and so is what has not reached the tolerance.
///
/// @param system          on one process; its load counts for nothing
/// @param loads           a column each, none zero, that do not depend on each other
/// @param preconditioned  M times them
/// @throws Error singular_system  a direction without positive energy
/// @cost   one product and one preconditioner for each load and iteration, all loads at once; nine vectors
/// for
///         each load
/// @source O'Leary, Linear Algebra Appl. 29 (1980); Dubrulle, ETNA 12 (2001)
BlockSolution solve_with_block_cg(const OperatorSystem& system, const Eigen::MatrixXd& loads,
                                  const Eigen::MatrixXd& preconditioned, const SolverOptions& options,
                                  const Progress& progress);

}  // namespace isopatch::solvers
