#pragma once

#include <vector>

namespace isopatch::iga {

/// Which block row of a matrix belongs to each node; nodes may share a row.
struct RowNumbering {
  std::vector<int> row_of_node;  ///< all patches one after the other; -1: none, only for nodes whose
                                 ///< functions are zero on all elements that are integrated
  int rows = 0;
};

}  // namespace isopatch::iga
