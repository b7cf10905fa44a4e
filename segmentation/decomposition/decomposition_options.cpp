#include "segmentation/decomposition/decomposition_options.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

void validate(const DecompositionOptions& options) {
  validate(options.search);
  validate(options.cut);
  if (!(options.time_limit > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("time_limit is {}; it must be above 0", options.time_limit));
  if (!(options.largest_blend > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("largest_blend is {}; it must be above 0", options.largest_blend));
  if (options.max_cells < 1)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("max_cells is {}; it must be 1 or more", options.max_cells));
}

}  // namespace isopatch::segmentation
