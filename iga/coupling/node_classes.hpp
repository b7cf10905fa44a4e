#pragma once

#include <span>
#include <vector>

#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// Nodes that are one point of the body: control points identified by interfaces, and those of collapsed
/// edges and faces, where anything but one common value would have infinite energy.
struct NodeClasses {
  std::vector<int> class_of;      ///< per node; classes are numbered by their first node
  std::vector<int> first_member;  ///< per class, into `members`, and the number of nodes at the end
  std::vector<int> members;       ///< nodes, increasing within a class

  int count() const { return static_cast<int>(first_member.size()) - 1; }
  std::span<const int> of(int node_class) const {
    const auto c = static_cast<std::size_t>(node_class);
    return std::span(members).subspan(static_cast<std::size_t>(first_member[c]),
                                      static_cast<std::size_t>(first_member[c + 1] - first_member[c]));
  }
};

/// @cost O(nodes), union-find
NodeClasses node_classes(const Discretization& discretization);
/// The same for spaces of the given sizes on the patches of a model, whose traces match.
/// @param sizes  functions per direction of every patch
NodeClasses node_classes(const geometry::MultiPatch& model, const std::vector<std::array<int, 3>>& sizes);

}  // namespace isopatch::iga
