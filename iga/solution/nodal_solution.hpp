#pragma once

#include "geometry/base/progress.hpp"
#include "iga/coupling/coupling_kind.hpp"
#include "iga/coupling/supported_system.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/problem/problem.hpp"
#include "solvers/solve.hpp"

namespace isopatch::iga {

/// All that a solution needs to know; the same on every process.
struct SolutionTask {
  const ElasticityProblem& problem;
  const NodeClasses& classes;
  const std::vector<SupportFrame>& frames;
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

}  // namespace isopatch::iga
