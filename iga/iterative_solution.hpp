#pragma once

#include "geometry/base/progress.hpp"
#include "iga/level.hpp"
#include "iga/problem.hpp"
#include "iga/supported_system.hpp"
#include "solvers/solve.hpp"

namespace isopatch::iga {

/// What an iterative solution needs to know, all of it the same on every process.
struct IterativeTask {
  const ElasticityProblem& problem;
  const NodeClasses& classes;
  const std::vector<Frame>& frames;
  const Eigen::Matrix3Xd& load;  ///< per node, (3, nodes), N
  ProcessesOfPatch processes;
  int process = 0;
  int points = 0;  ///< Gauss points per element and direction; 0: degree + 1
};

struct IterativeSolution {
  Eigen::Matrix3Xd displacement;  ///< per node, of the patches that this process has; 0 elsewhere. m
  Eigen::VectorXd multipliers;    ///< one per MultiplierRow, N; empty with elimination
  solvers::SolveReport report;
};

/// Patches coupled by elimination: conjugate gradients with the multigrid.
/// @throws Error whatever `solvers::solve_with_cg`, assembly and multigrid throw
/// @cost   matrix-free about 40 vectors of unknowns, assembled the matrix as well
IterativeSolution solve_eliminated(const IterativeTask& task, const solvers::SolverOptions& options,
                                   solvers::Operator form, const Progress& progress);

/// Patches coupled by multipliers: minimal residuals for the saddle point, whose operator keeps every patch
/// and every multiplier by itself, without a matrix. One process only.
///
/// K is singular on floating patches; K + g Q is not and has the same solution, Q the projection onto
/// jumps across interfaces and g a stiffness per class of nodes. The preconditioner is block diagonal: the
/// multigrid on what is continuous, 1 / g on jumps, g (B B^T)^-1 on multipliers. Nothing is factorized but
/// the multigrid's coarsest level.
///
/// @param rows  the multipliers
/// @source  Benzi, Golub, Liesen, Numerical solution of saddle point problems, Acta Numerica 2005, sections
/// 8, 10
IterativeSolution solve_with_multipliers(const IterativeTask& task, const std::vector<MultiplierRow>& rows,
                                         const solvers::SolverOptions& options, const Progress& progress);

}  // namespace isopatch::iga
