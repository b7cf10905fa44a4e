#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/base/progress.hpp"
#include "geometry/base/stopwatch.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::solvers {

enum class KrylovMethod { cg, minres };

/// Solves one system for one load after the other, each from the best combination of the solutions so far:
/// loads that depend on earlier ones cost no iterations, and what they share with them is not solved for
/// again.
///
/// Directions of loads are kept orthonormal in the norm of the preconditioner M, with their solutions; of a
/// new load only the part across them is solved for, to the tolerance of the whole. The error is then
/// computed afresh from the true residual, and solving goes on where combinations have left too much.
class LoadSequence {
 public:
  /// @param system  its load counts for nothing; must outlive this
  LoadSequence(const OperatorSystem& system, KrylovMethod method) : system_(&system), method_(method) {}

  /// @throws Error as `solve_with_cg` and `solve_with_minres` do
  /// @cost   of a first load its iterations and two vectors; from the second on two preconditioners beside
  /// the
  ///         iterations, and three vectors for each load that is new
  LinearSolution solve(const Eigen::VectorXd& load, const SolverOptions& options, const Progress& progress);

  /// The same for all loads; conjugate gradients on one process take some of them at once, where each costs
  /// fewer iterations (`solve_with_block_cg`).
  std::vector<LinearSolution> solve_all(const std::vector<Eigen::VectorXd>& loads,
                                        const SolverOptions& options, const Progress& progress);

 private:
  struct Direction {
    Eigen::VectorXd load;            // r with r.Mr = 1
    Eigen::VectorXd preconditioned;  // M r
    Eigen::VectorXd solution;        // of A x = r
  };
  struct Split {
    Eigen::VectorXd rest, preconditioned;
    std::vector<double> parts;  // along the directions known
    double size, across;        // of the load and of the rest, in the norm of M
  };
  /// @param preconditioned  M times the load
  Split split(const Eigen::VectorXd& load, Eigen::VectorXd preconditioned) const;
  // What a solution leaves of its load, and its size in the norm of M.
  struct Rest {
    Eigen::VectorXd load;
    double size;
  };
  Rest rest_of(const Eigen::VectorXd& load, const Eigen::VectorXd& x) const;
  LinearSolution solve_alone(const Eigen::VectorXd& load, const SolverOptions& options,
                             const Progress& progress) const;

  LinearSolution finished(LinearSolution start, const Eigen::VectorXd& load, double size, Rest rest,
                          const Stopwatch& watch, const SolverOptions& options,
                          const Progress& progress) const;
  static void add(const LinearSolution& part, double share, LinearSolution& to);
  std::vector<LinearSolution> solve_together(std::span<const Eigen::VectorXd> loads,
                                             const SolverOptions& options, const Progress& progress);

  const OperatorSystem* system_;
  KrylovMethod method_;
  std::vector<Direction> known_;
  LinearSolution first_;  // with what set-up took
  Eigen::VectorXd first_load_;
};

}  // namespace isopatch::solvers
