#include "segmentation/decomposition/combinatorics/search_options.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

void check_search(const char* field, int value, int least, int most) {
  if (value < least || value > most)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("SearchOptions::{} is {}, range {} .. {}", field, value, least, most));
}

}  // namespace

void validate(const SearchOptions& options) {
  constexpr int many = 1000000000;
  check_search("beam", options.beam, 1, 10000);
  check_search("branches", options.branches, 1, 1000);
  check_search("evaluations", options.evaluations, 1, many);
  check_search("refusals", options.refusals, 1, many);
  check_search("cuts", options.cuts, 0, many);
  check_search("max_length", options.max_length, 3, 500);
  check_search("alternatives", options.alternatives, 1, 1000);
  check_search("considered", options.considered, 1, many);
  validate(options.cost);
}

}  // namespace isopatch::segmentation
