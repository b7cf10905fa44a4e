#pragma once

#include <string>

#include "geometry/base/progress.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"

namespace isopatch::app {

/// Topological hexahedra to be made patches: files and how.
struct BlocksInput {
  segmentation::BlockFiles files;
  segmentation::ParameterizationOptions options;
};

/// Reads the blocks and parameterizes them; lengths are metres.
/// @throws Error as `read_blocks` and `parameterize` do
segmentation::Parameterization parameterized(const BlocksInput& input, const Progress& progress = {});

/// A report as a table, for people.
std::string parameterization_text(const segmentation::ParameterizationReport& report);

}  // namespace isopatch::app
