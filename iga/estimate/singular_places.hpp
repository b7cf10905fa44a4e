#pragma once

#include <optional>
#include <string>
#include <vector>

#include "iga/estimate/error_estimate.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Why the stress at a place may have no limit, so that it grows with refinement: within a quarter of an
/// element runs an edge of the part that is re-entrant ("a re-entrant edge of 270 degrees"), at which a
/// clamped face ends, at which materials meet in the open, or which is held as a line; or the rim of a part
/// of a face that is held, or within an element a point that is held or loaded. Nothing where there is none.
///
/// Edges of patches are looked at, so an edge inside a patch's face is not seen; angles that vary along an
/// edge count by the largest of five. Clamped faces end without harm at angles below 60 degrees.
/// @source Williams, J. Appl. Mech. 19 (1952): exponents below 1 from 180 degrees on if free, from some 60 if
///         clamped on one side
/// @cost   that of `global_nodes`, once for all places
std::vector<std::optional<std::string>> singular_places(const ElasticityProblem& problem,
                                                        const std::vector<PatchPlace>& places);

}  // namespace isopatch::iga
