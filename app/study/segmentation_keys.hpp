#pragma once

#include "app/study/keys.hpp"
#include "segmentation/decomposition/decompose.hpp"

namespace isopatch::app {

/// What [segmentation] says.
struct SegmentationKeys {
  segmentation::DecompositionOptions options;
};

const Keys<SegmentationKeys>& segmentation_keys();

}  // namespace isopatch::app
