#pragma once

#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"

namespace isopatch::app {

/// Topological hexahedra to be made patches: files and how.
struct BlocksInput {
  segmentation::BlockFiles files;
  segmentation::ParameterizationOptions options;
};

}  // namespace isopatch::app
