#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::iga {

/// A place in a patch, in the naming of the discretization.
struct PatchPlace {
  int patch = 0;
  geometry::Parameter<3> parameter = geometry::Parameter<3>::Zero();
};

/// How far a solution is from the exact one of the same problem: the error of the discretization, without
/// that of the model, of supports, loads and material.
struct ErrorEstimate {
  double energy = 0;  ///< of the error, J: half its energy norm squared. Where loads alone act, the
                      ///< solution's energy is too small by it.
  /// Energy norm of the error over that of the solution, the root of the ratio of their energies; at most 1.
  double relative = 0;
  std::vector<ElementErrors> elements;     ///< one per patch
  std::vector<Eigen::Matrix3d> stress_at;  ///< of the error at each place asked for, Pa
  int iterations = 0;
};

/// One of several solutions whose errors are estimated together.
struct SolutionToEstimate {
  const Eigen::Matrix3Xd& loads;  ///< from `ErrorEstimator::loads`
  const ElasticField& solution;  ///< of `solve_elasticity` or `solve_cases` with either coupling and the same
                                 ///< options
  std::vector<PatchPlace> places = {};  ///< whose stress errors are wanted
};

/// Estimates the error of a solution by what functions of one degree more on the same elements, as continuous
/// across their knots as before, would still change.
///
/// That change is a displacement of its own, conforming and with the residual of the solution as its load. It
/// is found by a few conjugate gradients with the multigrid's smoother, because the residual is orthogonal to
/// the functions of the solution and so changes from element to element. Each iteration comes from below, and
/// what one degree more cannot follow is left out, so the estimate is rather too small than too large: by
/// less than a tenth where the solution is smooth, by some 30 % at re-entrant edges and other places where
/// stress grows without limit.
///
/// Where springs stand for holds (`SprungFace::is_hold`) the raised functions are held everywhere, and what
/// that costs the springs is no error: the strain energy of the correction counts.
///
/// Across faces that do not match the raised functions are coupled by Nitsche's method. Where the solution
/// has mortar multipliers, what its jumps would cost there is no error either.
///
/// One set-up serves any number of load cases and sums of them.
///
/// @throws Error out_of_memory  before anything large exists, saying what it would need
/// @throws Error fold_over      a Gauss point with det J <= 0, of which there are more than in the solution
/// @cost   of the set-up, the diagonal of the raised stiffness and the smoother; of every solution seven to
///         fifteen products of the raised space, whose unknowns are up to eight times as many and whose
///         products cost two to four times as much; 180 bytes for each of these unknowns
/// @source the idea of hierarchical bases as in Bank, Smith, SIAM J. Numer. Anal. 30 (1993), (2.9)
class ErrorEstimator {
 public:
  /// @param problem  must outlive this; of its loads nothing is used
  ErrorEstimator(const ElasticityProblem& problem, const ElasticityOptions& options = {},
                 const Progress& progress = {});
  ~ErrorEstimator();
  ErrorEstimator(ErrorEstimator&&) noexcept;

  /// The loads of a problem with the same discretization and materials, as `of_case` makes it, in the raised
  /// space: (3, raised nodes), N. They add up as loads do.
  Eigen::Matrix3Xd loads(const ElasticityProblem& problem) const;

  /// @param loads     of the solution, from `loads`
  /// @param solution  of `solve_elasticity` or `solve_cases` with either coupling and the same options
  /// @param places    whose stress errors are wanted
  /// @return          the same on all processes
  ErrorEstimate estimate(const Eigen::Matrix3Xd& loads, const ElasticField& solution,
                         const std::vector<PatchPlace>& places = {}, const Progress& progress = {}) const;

  /// The same for several solutions, whose products are computed together.
  /// @cost  in memory 150 bytes for each unknown of the raised space and each solution
  std::vector<ErrorEstimate> estimates(const std::vector<SolutionToEstimate>& solutions,
                                       const Progress& progress = {}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same for one solution of a problem under its own loads.
ErrorEstimate estimate_error(const ElasticityProblem& problem, const ElasticField& solution,
                             const std::vector<PatchPlace>& places = {},
                             const ElasticityOptions& options = {}, const Progress& progress = {});

}  // namespace isopatch::iga
