#pragma once

#include "segmentation/decomposition/combinatorics/search_options.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"

namespace isopatch::segmentation {

struct DecompositionOptions {
  SearchOptions search = {.beam = 12,
                          .branches = 16,
                          .evaluations = 20000,
                          .refusals = 5000,
                          .extensions = false,
                          .cost = {.t_joint = 2}};
  CutOptions cut = {};
  double time_limit = 60;  ///< seconds, after which it is given up; above 0
  int max_cells = 2000;    ///< at most so many cells while sides are made to meet; range 1 ..
  bool operator==(const DecompositionOptions&) const = default;
};
void validate(const DecompositionOptions& options);

}  // namespace isopatch::segmentation
