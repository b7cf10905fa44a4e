#pragma once

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Checks that det J > 0 at all Gauss points, as the integration will.
/// @param points  Gauss points per element and direction; 0: degree + 1
/// @throws Error fold_over  naming patch, parameter and place
/// @cost   some 200 flops per Gauss point; memory for one plane of them
void require_unfolded(const Discretization& discretization, int points = 0);

/// Checks a problem as `solve_elasticity` does before it solves, so that a study can be tried without solving
/// it.
/// @throws Error as `solve_elasticity` does: materials, loads and supports that cannot be, supports that
///     contradict each other or leave rigid motions, folded patches
/// @cost   O(nodes), and as `require_unfolded`
void require_well_posed(const ElasticityProblem& problem, int points = 0);

}  // namespace isopatch::iga
