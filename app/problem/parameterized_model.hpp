#pragma once

#include <string>

#include "app/study/blocks_input.hpp"
#include "geometry/base/progress.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// Reads the blocks and parameterizes them; lengths are metres.
/// @throws Error as `read_blocks` and `parameterize` do
segmentation::Parameterization parameterized(const BlocksInput& input, const Progress& progress = {});

/// A report as a table, for people.
std::string parameterization_text(const segmentation::ParameterizationReport& report);

}  // namespace isopatch::app
