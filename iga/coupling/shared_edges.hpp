#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// Of a face, per direction along it and for its low and high end: whether a displacement of the edge there
/// is not the face's alone, since it is collapsed, another patch or another slave face has it too or a
/// support holds it.
using SharedEdges = std::array<std::array<bool, 2>, 2>;

/// For each component of the displacement; nothing where supports hold it at all nodes of the face. Supports
/// count for the components that they hold, or for all where they hold obliquely to the coordinate axes.
/// @param slaves  all faces that follow others
/// @param frames  one per global node
std::array<std::optional<SharedEdges>, 3> shared_edges(const geometry::PatchFace& face,
                                                       const std::vector<geometry::PatchFace>& slaves,
                                                       const Discretization& discretization,
                                                       const GlobalNodes& global,
                                                       const std::vector<SupportFrame>& frames);

/// The free axis of a frame that is a coordinate axis, or -1 if there is none.
int free_axis_along(const SupportFrame& frame, int component);

}  // namespace isopatch::iga
