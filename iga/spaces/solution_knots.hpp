#pragma once

#include "geometry/multi_patch.hpp"
#include "iga/spaces/discretization_options.hpp"
#include "iga/spaces/matching_spaces.hpp"

namespace isopatch::iga {

/// Knots of the solution space, before any of its control points exist: `discretize` refines to these.
///
/// Where neighbours differ in degree or knots, both get the union, and so on from patch to patch until all
/// traces match; but for what `options` does not let spread.
///
/// @throws Error invalid_argument  options out of range
/// @throws Error not_conforming    an interface whose knots cannot be matched
/// @cost   O(knots)
DirectionKnots solution_knots(const geometry::MultiPatch& model, const DiscretizationOptions& options = {});

/// The model as the solution space sees it: interfaces whose sides have other functions are non-matching
/// ones.
/// @param knots  of all patches, as `solution_knots` gives them
geometry::MultiPatch solution_model(const geometry::MultiPatch& model, const DirectionKnots& knots);

}  // namespace isopatch::iga
