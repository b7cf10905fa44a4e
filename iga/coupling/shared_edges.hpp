#pragma once

#include <array>
#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// Of a face, per direction along it and for its low and high end: whether displacements of the edge there
/// are not the face's alone, since it is collapsed, another patch has it too or a support holds it in part.
using SharedEdges = std::array<std::array<bool, 2>, 2>;

/// @param frames  one per global node
SharedEdges shared_edges(const geometry::PatchFace& face, const Discretization& discretization,
                         const GlobalNodes& global, const std::vector<SupportFrame>& frames);

}  // namespace isopatch::iga
