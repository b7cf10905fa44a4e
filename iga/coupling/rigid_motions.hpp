#pragma once

#include <string>
#include <vector>

#include "iga/coupling/support_frames.hpp"

namespace isopatch::iga {

/// A body that its supports leave free to move.
struct FreeBody {
  std::vector<PatchId> patches;
  std::vector<std::string>
      motions;  ///< "translation along z", "rotation about the axis through (...) m along (0.6, 0.8, 0)"
};

/// Bodies whose supports leave rigid motions. Empty if the problem is well posed.
/// @cost  O(nodes)
std::vector<FreeBody> free_bodies(const ElasticityProblem& problem, const GlobalNodes& global,
                                  const std::vector<SupportFrame>& frames);

/// @throws Error free_body naming patches and motions if `free_bodies` finds any
void require_supported(const ElasticityProblem& problem, const GlobalNodes& global,
                       const std::vector<SupportFrame>& frames);

}  // namespace isopatch::iga
