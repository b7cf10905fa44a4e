#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace isopatch {

/// Disjoint sets of the numbers below a count; the smallest member represents its set.
/// @cost  nearly O(1) a call, amortized
class UnionFind {
 public:
  explicit UnionFind(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// The smallest member of the set of i.
  int find(int i) {
    while (parent(i) != i) {
      parent(i) = parent(parent(i));
      i = parent(i);
    }
    return i;
  }
  /// The same without shortening ways: for several threads at once.
  int find(int i) const {
    while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
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
  /// How many sets there are.
  int set_count() const {
    int count = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) count += parent_[i] == static_cast<int>(i);
    return count;
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

/// Disjoint sets of things with a direction, such as edges: each member runs along with the smallest member
/// of its set or against it.
class SignedUnionFind {
 public:
  explicit SignedUnionFind(int count) : links_(static_cast<std::size_t>(count)) {
    for (int i = 0; i < count; ++i) links_[static_cast<std::size_t>(i)].root = i;
  }
  struct Member {
    int root = 0;
    bool against = false;
    bool operator==(const Member&) const = default;
  };
  /// The smallest member of the set of i, and whether i runs against it.
  Member find(int i) {
    if (link(i).root == i) return {i, false};
    const Member above = find(link(i).root);
    link(i) = {above.root, link(i).against != above.against};
    return link(i);
  }
  /// The same without shortening ways: for several threads at once.
  Member find(int i) const {
    Member found{i, false};
    for (;;) {
      const Member& next = links_[static_cast<std::size_t>(found.root)];
      if (next.root == found.root) return found;
      found = {next.root, found.against != next.against};
    }
  }
  /// @param against  whether j runs against i
  /// @return  false if both are in one set already, the other way around; nothing changes then
  bool unite(int i, int j, bool against) {
    const Member first = find(i), second = find(j);
    const bool turned = against != (first.against != second.against);
    if (first.root == second.root) return !turned;
    link(std::max(first.root, second.root)) = {std::min(first.root, second.root), turned};
    return true;
  }

 private:
  Member& link(int i) { return links_[static_cast<std::size_t>(i)]; }
  std::vector<Member> links_;
};

}  // namespace isopatch
