#pragma once

#include <optional>
#include <vector>

#include "app/base/warning.hpp"
#include "app/problem/built_problem.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// Warnings about what a study says: names that two supports, loads, probes or sections share, and moduli,
/// densities, yield stresses and expansions that no solid has.
std::vector<Warning> input_warnings(const Study& study);

/// Warnings about what came out: loads that move nothing, displacements larger than the part, strains for
/// which linear elasticity is wrong, places where stresses say nothing, and elements that cannot represent
/// the displacements, unless the estimated error is small.
/// @param error  as estimated, relative in the energy norm
std::vector<Warning> result_warnings(const BuiltProblem& built, const iga::ElasticitySolution& solution,
                                     const std::optional<double>& error = {});

}  // namespace isopatch::app
