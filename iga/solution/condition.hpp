#pragma once

#include "geometry/base/progress.hpp"
#include "iga/coupling/coupling_kind.hpp"
#include "iga/problem/problem.hpp"
#include "solvers/condition.hpp"

namespace isopatch::iga {

/// The condition of the equations that a coupling leads to, as they are factorized, supports brought in.
/// @param points  Gauss points per element and direction; 0: degree + 1
/// @throws Error whatever assembly and `solvers::estimate_condition` throw
/// @cost   an assembly and thirty direct solutions
solvers::ConditionEstimate estimate_condition(const ElasticityProblem& problem, Coupling coupling,
                                              int points = 0, const Progress& progress = {});

}  // namespace isopatch::iga
