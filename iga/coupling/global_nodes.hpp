#pragma once

#include <array>
#include <span>
#include <vector>

#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// The global numbering of nodes: which control points of the patches are one point of the body. These are
/// the ones that interfaces identify, and those of a collapsed edge or face, where anything but one common
/// value would have infinite energy.
struct GlobalNodes {
  std::vector<int> global_of;     ///< per node; global nodes are numbered by their first node
  std::vector<int> first_member;  ///< per global node, into `members`, and the number of nodes at the end
  std::vector<int> members;       ///< nodes, increasing within a global node

  int count() const { return static_cast<int>(first_member.size()) - 1; }
  /// The nodes that are one global node, increasing.
  std::span<const int> nodes_of(int global_node) const {
    const auto c = static_cast<std::size_t>(global_node);
    return std::span(members).subspan(static_cast<std::size_t>(first_member[c]),
                                      static_cast<std::size_t>(first_member[c + 1] - first_member[c]));
  }
};

/// Numbers the nodes of the solution space globally.
/// @cost O(nodes), union-find
GlobalNodes global_nodes(const Discretization& discretization);
/// The same for spaces of the given sizes on the patches of a model, whose traces match.
/// @param sizes  functions per direction of every patch
GlobalNodes global_nodes(const geometry::MultiPatch& model, const std::vector<std::array<int, 3>>& sizes);

}  // namespace isopatch::iga
