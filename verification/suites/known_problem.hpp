#pragma once

#include <functional>
#include <string>
#include <vector>

#include "iga/solution/solve_elasticity.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/exact_solution.hpp"

namespace isopatch::verification {

/// A problem that can be posed on any mesh and whose solution is known.
struct KnownProblem {
  std::string name;  ///< "8 distorted patches in random orientations"
  ReferenceKind kind = ReferenceKind::closed_form;
  std::string source;  ///< "Goodier"
  ExactSolution exact;
  std::function<iga::ElasticityProblem(int degree, int elements)> posed;
  int points = 0;  ///< Gauss points of the assembly per element and direction; 0: p + 2
};

/// Levels on which a convergence is measured.
struct Levels {
  int degree = 1;
  std::vector<int> elements = {};  ///< per direction and patch, increasing
  iga::Coupling coupling = iga::Coupling::elimination;
  bool iterate = false;  ///< conjugate gradients or minimal residuals to 1e-12, for levels that are too large
                         ///< to be factorized in little time
  iga::NonMatchingCoupling non_matching = iga::NonMatchingCoupling::nitsche;  ///< where faces do not match
};

/// Claims order p + 1 of the displacement in L2 and order p in the energy norm, two-sided within 0.15 between
/// every two levels. Errors are integrated with p + 4 points.
void expect_orders(const KnownProblem& problem, const Levels& levels);

/// A problem with one material everywhere, without supports and loads.
iga::ElasticityProblem unloaded(const geometry::MultiPatch& model, const iga::DiscretizationOptions& options,
                                const iga::Material& material);

/// The tractions that go with a known displacement.
iga::SurfaceLoad exact_tractions(std::vector<geometry::PatchFace> faces, const ExactSolution& exact,
                                 const iga::Material& material);

}  // namespace isopatch::verification
