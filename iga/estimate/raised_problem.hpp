#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// The same problem with functions of one degree more on the same elements, as continuous across their knots
/// as before: a space that contains the given one, with up to eight times its nodes.
/// @param points  Gauss points per element and direction that the solution was made with; 0: those of the
///                discretization. Patches have as many again, and no fewer than the raised degree + 1.
/// @throws Error unsupported  more control points than 32-bit indices can count
/// @cost   O(nodes)
ElasticityProblem with_degree_raised(const ElasticityProblem& problem, int points = 0);

/// The coefficients of the same displacement in the raised space, (3, raised nodes), m.
/// @param displacement  coefficients of each patch of `problem`
Eigen::Matrix3Xd in_raised_space(const ElasticityProblem& problem, const ElasticityProblem& raised,
                                 const std::vector<Eigen::Matrix3Xd>& displacement);

}  // namespace isopatch::iga
