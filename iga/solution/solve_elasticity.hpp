#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/coupling/coupling_kind.hpp"
#include "iga/coupling/interface_roles.hpp"
#include "iga/post/elasticity_results.hpp"
#include "iga/post/stress_points.hpp"
#include "iga/problem/load_case.hpp"
#include "iga/problem/problem.hpp"
#include "iga/problem/unresolved_energy.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "solvers/processes.hpp"
#include "solvers/solve.hpp"

namespace isopatch::iga {

struct ElasticityOptions {
  Coupling coupling = Coupling::elimination;
  NonMatchingCoupling non_matching = NonMatchingCoupling::nitsche;
  MortarSide mortar_side = MortarSide::automatic;  ///< which faces that do not match have the multipliers
  solvers::SolverOptions solver = {};
  /// Gauss points per element and direction in volumes; 0: degree + 1, and more where the map of a patch
  /// needs them (`Discretization::gauss_points`). Range 0 .. 20.
  int quadrature_points = 0;
  /// Among which the elements are spread. All of them call `solve_elasticity` with the same problem and
  /// options and get the same solution.
  solvers::Processes processes = {};
  bool operator==(const ElasticityOptions&) const = default;
};

/// Sizes of the discrete problem. Scalar counts, three components a node.
struct ProblemSize {
  std::int64_t elements = 0;
  std::int64_t control_points = 0;   ///< summed over the patches
  std::int64_t dofs_uncoupled = 0;   ///< 3 control_points
  std::int64_t dofs_eliminated = 0;  ///< 3 times the global nodes
  std::int64_t multipliers = 0;      ///< dofs_uncoupled - dofs_eliminated: rows that tie the patches
  std::int64_t multipliers_free =
      0;  ///< of these, the rows that remain: those in components that supports fix are dropped
  std::int64_t mortar_multipliers = 0;  ///< between faces that do not match
  std::int64_t dofs = 0;  ///< unknowns of the chosen coupling before supports are fixed, multipliers included
  std::int64_t dofs_free = 0;  ///< the same after supports are fixed
};

/// What holds a face to others that it does not match, by multipliers.
struct MortarTie {
  MortarFace face;
  int multipliers = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< of the masters on the slave, N
};

struct ElasticitySolution {
  ElasticField field;
  std::vector<Multiplier> multipliers;  ///< solved for with lagrange, recovered from the residual with
                                        ///< elimination and where lagrange was solved without them
  std::vector<MortarTie> mortar;        ///< empty with Nitsche's method
  ElasticityResults results;
  ProblemSize size;
  solvers::SolveReport solver;
  std::int64_t predicted_bytes =
      0;  ///< what assembly and solver were expected to take at most, before they began
  std::vector<PhaseTime> timings;
};

/// Solves a linear elasticity problem.
///
/// Spread over processes, elements, matrices and Krylov vectors are distributed; what is per node (geometry,
/// loads, displacements) is kept by every process.
///
/// Checks before any assembly: materials, supports that contradict each other, loads on faces that are no
/// boundary, bodies that can still move.
///
/// @throws Error conflict    supports that contradict each other
/// @throws Error free_body   naming the body's patches and its rigid motions left
/// @throws Error fold_over   a Gauss point with a Jacobian determinant that is not positive, saying where
/// @throws Error singular_system  a solution with values that are not finite
/// @throws Error             whatever `solvers::solve` throws
ElasticitySolution solve_elasticity(const ElasticityProblem& problem, const ElasticityOptions& options = {},
                                    const Progress& progress = {});

/// Solves for several load cases with one set-up: the problem is numbered, assembled and factorized, or its
/// multigrid made, once. Each solution is that of `solve_elasticity` on `of_case`, but for the round-off of
/// sums in another order.
///
/// Combinations are sums of the cases' displacements, so that nothing is solved for them; energies, largest
/// values and reactions are computed from the sums.
///
/// @return  a solution for every case, then for every combination; the first has the times of all
/// @throws Error as `solve_elasticity` and `of_case` do, and `validate` of the cases
/// @cost   of every case: its load, its iterations or a share in going through the factors, and its results
std::vector<ElasticitySolution> solve_cases(const ElasticityProblem& problem, const LoadCases& cases,
                                            const ElasticityOptions& options = {},
                                            const Progress& progress = {});

}  // namespace isopatch::iga
