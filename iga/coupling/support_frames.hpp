#pragma once

#include <vector>

#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frame.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// One frame per global node. Elastic supports leave them as they are; those of free bodies come last.
/// @throws Error invalid_argument  a plane support on a face that is not plane, a support that needs faces on
/// an edge or a corner, a cylindrical one whose faces touch its axis, a face that is not on the boundary, an
/// edge or a corner of a patch that does not exist
/// @throws Error conflict          supports that prescribe different displacements for one point, naming both
std::vector<SupportFrame> support_frames(const ElasticityProblem& problem, const GlobalNodes& global);

}  // namespace isopatch::iga
