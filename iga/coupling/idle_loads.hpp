#pragma once

#include <string>
#include <vector>

#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Names of the surface loads that move nothing: supports hold the part wherever and in whatever direction
/// they act, as a pressure on a clamped face.
/// @param frames  one per global node
/// @cost  that of the surface loads' part of the load vector
std::vector<std::string> idle_loads(const ElasticityProblem& problem, const GlobalNodes& global,
                                    const std::vector<SupportFrame>& frames);

}  // namespace isopatch::iga
