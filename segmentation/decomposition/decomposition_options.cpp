#include "segmentation/decomposition/decomposition_options.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

bool is_cut_by_hand(const DecompositionOptions& options) {
  return !options.cuts.empty() || options.symmetry;
}

void validate(const DecompositionOptions& options) {
  validate(options.search);
  validate(options.cut);
  if (!(options.time_limit > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("time_limit is {}; it must be above 0", options.time_limit));
  if (!(options.largest_blend > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("largest_blend is {}; it must be above 0", options.largest_blend));
  for (const GivenPlane& cut : options.cuts) validate(cut);
  if (options.symmetry) validate(*options.symmetry);
  if (is_cut_by_hand(options) && options.method == Method::cuts)
    throw Error(ErrorCode::invalid_argument,
                "cuts by hand and symmetry lead to pieces that are swept; the method cuts has none");
  if (options.max_cells < 1)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("max_cells is {}; it must be 1 or more", options.max_cells));
}

}  // namespace isopatch::segmentation
