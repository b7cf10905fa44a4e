#pragma once

#include <vector>

#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frame.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Takes the rigid motions that other supports leave to each body by as many conditions at corners of patches
/// as there are motions: three components at one corner, two at another, one at a third for a body that
/// nothing else holds. They are statically determinate: whatever the body's deformation, they take the
/// imbalance of the loads and no more.
///
/// Corners and directions are chosen one after the other where they hold most of what is still free.
///
/// @param support  index of the support that holds them, a FreeBodySupport
/// @param frames   one per global node, with all other supports in them; more directions become fixed
/// @cost  O(nodes), and six times the corners of all patches
void hold_free_bodies(const ElasticityProblem& problem, int support, const GlobalNodes& global,
                      std::vector<SupportFrame>& frames);

}  // namespace isopatch::iga
