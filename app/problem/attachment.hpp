#pragma once

#include <vector>

#include "app/study/attachment_input.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// The patches with all attachments, one after the other: later ones may name faces of earlier ones.
/// @throws Error invalid_argument, beginning with the attachment's place, for faces that do not exist and
/// maps
///     that leave a patch without thickness
geometry::PatchSet attached(geometry::PatchSet set, const std::vector<AttachmentInput>& attachments);

}  // namespace isopatch::app
