#pragma once

#include <optional>

#include "app/base/warning.hpp"
#include "iga/problem/problem.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// Share of the internal energy that sits in the highest modes of the elements: about the relative error of
/// energy and displacements. 0 without energy.
double unresolved_share(const iga::ElasticityResults& results);

/// A warning where the elements cannot represent the displacements: nearly incompressible material at a low
/// degree, degree 1 in bending, elements that are too large. It gives the share and which degree or
/// refinement is needed.
std::optional<Warning> resolution_warning(const iga::ElasticityProblem& problem,
                                          const iga::ElasticityResults& results);

/// A warning where the volume hardly changes, so that the mean of the normal stresses, of displacements of one
/// degree, oscillates about what is right: components and principal stresses do so with it.
std::optional<Warning> pressure_warning(const iga::ElasticityProblem& problem);

}  // namespace isopatch::app
