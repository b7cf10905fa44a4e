#pragma once

#include <string>

#include "iga/nodal_solution.hpp"

namespace isopatch::iga {

/// What will solve a problem, and the memory it is going to take.
struct SolverChoice {
  solvers::Method method = solvers::Method::automatic;
  solvers::Operator form = solvers::Operator::assembled;
  std::string reason;                ///< of an iterative method; `solvers::solve` explains direct ones
  std::int64_t predicted_bytes = 0;  ///< of this process at its peak, beyond what it holds before
};

/// Chooses what the options leave open, before anything is assembled.
///
/// The stored blocks are counted exactly; the factors of direct methods are estimated from the growth of
/// nested dissection, which measured runs calibrate (solvers/README.md). Small problems are factorized; large
/// ones, and those whose factors would not fit, iterate with a multigrid, without a matrix unless it is
/// smaller than what computing its product anew would be worth.
///
/// @throws Error out_of_memory     if the prediction for a method asked for by name, or for the most sparing
/// one,
///                                 exceeds what is available; with the number of unknowns that would fit
/// @throws Error invalid_argument  a method that cannot treat the coupling
SolverChoice choose_solver(const SolutionTask& task, const solvers::SolverOptions& options);

}  // namespace isopatch::iga
