#pragma once

#include "geometry/base/progress.hpp"
#include "iga/distribution.hpp"
#include "iga/problem.hpp"
#include "iga/supported_system.hpp"
#include "solvers/solve.hpp"

namespace isopatch::iga {

/// How patches are held together.
enum class Coupling {
  elimination,  ///< coincident control points share their unknowns: a positive definite system
  lagrange,     ///< every patch keeps its unknowns, multipliers tie them: a saddle point
};
std::string_view name(Coupling coupling);
inline constexpr std::array all_couplings = {Coupling::elimination, Coupling::lagrange};

/// All that a solution needs to know; the same on every process.
struct SolutionTask {
  const ElasticityProblem& problem;
  const NodeClasses& classes;
  const std::vector<Frame>& frames;
  const std::vector<MultiplierRow>& multipliers;
  const Eigen::Matrix3Xd& load;  ///< per node, (3, nodes), N
  const Distribution& distribution;
  const solvers::Processes& processes;
  Coupling coupling = Coupling::elimination;
  int points = 0;  ///< Gauss points per element and direction; 0: degree + 1
};

/// The unknowns of a solved problem, the same on every process.
struct NodalSolution {
  Eigen::Matrix3Xd displacement;  ///< per node, of all patches, m
  Eigen::VectorXd multipliers;    ///< one per MultiplierRow, N; empty with elimination
  solvers::SolveReport report;
};

/// Assembles the system and gives it to `solvers::solve`.
/// @throws Error whatever assembly and `solvers::solve` throw
NodalSolution solve_assembled(const SolutionTask& task, const solvers::SolverOptions& options,
                              const Progress& progress);

}  // namespace isopatch::iga
