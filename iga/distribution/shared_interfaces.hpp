#pragma once

#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Gives whatever ties patches at interfaces that do not match to one process each: to the one with most of
/// their nodes, which gets an empty share of the patches that it has nothing of.
///
/// Interfaces that share a patch or a node stay together, so what their unknowns have in common is summed and
/// factorized in one place, as by a single process.
/// @param global  the nodes that are one
/// @cost  O(nodes)
void share_interfaces(const geometry::MultiPatch& model, const std::vector<PatchSpace>& spaces,
                      const GlobalNodes& global, Distribution& distribution);

/// Spreads patches over processes, and what ties them where they do not match.
Distribution distribute(const geometry::MultiPatch& model, const std::vector<PatchSpace>& spaces,
                        const GlobalNodes& global, int processes);

}  // namespace isopatch::iga
