#pragma once

#include "app/study/keys.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::app {

/// What [segmentation] says.
struct SegmentationKeys {
  segmentation::DecompositionOptions options;
};

const Keys<SegmentationKeys>& segmentation_keys();
/// Of [[segmentation.cut]].
const Keys<segmentation::GivenPlane>& given_plane_keys();

/// "remove" or "keep".
const Choices<segmentation::TJoints>& t_joint_choices();

/// "automatic" or "cuts".
const Choices<segmentation::Method>& method_choices();

/// "keep" or "remove".
const Choices<segmentation::Blends>& blend_choices();

}  // namespace isopatch::app
