#pragma once

#include <string>

#include "geometry/base/progress.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// A study's way to couple faces that do not match beside the other one, of Nitsche's method and mortar
/// multipliers. Both are right up to the error of the discretization.
struct NonMatchingComparison {
  iga::NonMatchingCoupling own = iga::NonMatchingCoupling::nitsche;
  iga::NonMatchingCoupling other = iga::NonMatchingCoupling::mortar;
  std::string failure;                 ///< why the other way gave nothing; the figures below are 0 then
  double energy = 0;                   ///< J, of the own way, with what couples the faces
  double other_energy = 0;             ///< J
  double displacement_difference = 0;  ///< largest of a coefficient, over the largest coefficient
  double estimated_error = 0;          ///< of the own way, energy norm, relative
  solvers::SolveReport solver;         ///< of the other way

  double energy_difference() const;  ///< over the own energy
  /// Twice the energy of the estimated error, over the energy.
  double allowed_difference() const { return 2 * estimated_error * estimated_error; }
  bool agree() const { return failure.empty() && energy_difference() <= allowed_difference(); }
};

/// Solves once more with the other way.
/// @param options   of the solution
/// @param solution  of the problem, whose faces do not match somewhere
/// @cost  another solution, and an estimate of the error
NonMatchingComparison compare_non_matching(const iga::ElasticityProblem& problem,
                                           const iga::ElasticityOptions& options,
                                           const iga::ElasticitySolution& solution,
                                           const Progress& progress = {});

}  // namespace isopatch::app
