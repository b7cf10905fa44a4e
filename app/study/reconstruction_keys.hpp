#pragma once

#include "app/base/choices.hpp"
#include "app/study/keys.hpp"
#include "segmentation/reconstruction/reconstruction_options.hpp"

namespace isopatch::app {

/// What [reconstruction] says.
struct ReconstructionKeys {
  segmentation::ReconstructionOptions options;
};

const Keys<ReconstructionKeys>& reconstruction_keys();

/// "carriers" or "angles".
const Choices<segmentation::RegionMethod>& region_method_choices();

}  // namespace isopatch::app
