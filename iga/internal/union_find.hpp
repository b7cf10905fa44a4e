#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace isopatch::iga {

/// Disjoint sets of the numbers below a count; the smallest member represents its set.
class UnionFind {
 public:
  explicit UnionFind(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent(i) != i) {
      parent(i) = parent(parent(i));
      i = parent(i);
    }
    return i;
  }
  /// @return  false if both were in one set already
  bool unite(int i, int j) {
    i = find(i);
    j = find(j);
    if (i == j) return false;
    parent(std::max(i, j)) = std::min(i, j);
    return true;
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

}  // namespace isopatch::iga
