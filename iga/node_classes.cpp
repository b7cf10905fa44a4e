#include "iga/node_classes.hpp"

#include <numeric>

#include "geometry/collapse.hpp"
#include "iga/internal/union_find.hpp"
#include "iga/matching_spaces.hpp"

namespace isopatch::iga {
namespace {

// Control points of collapsed edges, and of each line of a side along a direction in which it is collapsed.
void unite_collapsed(const Discretization& d, int patch, UnionFind& nodes) {
  const auto& original = d.model.patches()[static_cast<std::size_t>(patch)];
  const std::array<int, 3> sizes = d.patches[static_cast<std::size_t>(patch)].sizes();
  const double tolerance = d.model.tolerance().same_point * d.model.size();
  const int offset = d.first_node[static_cast<std::size_t>(patch)];
  for (const geometry::PatchEdge& edge : geometry::all_edges()) {
    if (!geometry::is_collapsed(original, edge, tolerance)) continue;
    const std::vector<int> points = geometry::edge_control_points(sizes, edge);
    for (const int point : points) nodes.unite(offset + points[0], offset + point);
  }
  for (const geometry::Side side : geometry::all_sides) {
    const std::vector<int> points = geometry::face_control_points(sizes, side);
    const auto directions = geometry::tangents(side);
    const std::size_t row = static_cast<std::size_t>(sizes[static_cast<std::size_t>(directions[0])]);
    const bool along_first = geometry::is_collapsed(original, side, directions[0], tolerance);
    const bool along_second = geometry::is_collapsed(original, side, directions[1], tolerance);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (along_first) nodes.unite(offset + points[i - i % row], offset + points[i]);
      if (along_second) nodes.unite(offset + points[i % row], offset + points[i]);
    }
  }
}

}  // namespace

NodeClasses node_classes(const Discretization& d) {
  UnionFind nodes(d.node_count());
  for (const geometry::Interface& interface : d.model.interfaces()) {
    const int first = d.first_node[static_cast<std::size_t>(interface.first.patch.value)];
    const int second = d.first_node[static_cast<std::size_t>(interface.second.patch.value)];
    for (const auto& [i, j] : matching_control_points(interface, d.patches))
      nodes.unite(first + i, second + j);
  }
  for (int patch = 0; patch < d.patch_count(); ++patch) unite_collapsed(d, patch, nodes);

  NodeClasses result;
  result.class_of.resize(static_cast<std::size_t>(d.node_count()));
  int count = 0;
  for (int node = 0; node < d.node_count(); ++node) {
    const int root = nodes.find(node);
    result.class_of[static_cast<std::size_t>(node)] =
        root == node ? count++ : result.class_of[static_cast<std::size_t>(root)];
  }
  result.first_member.assign(static_cast<std::size_t>(count) + 1, 0);
  for (const int c : result.class_of) ++result.first_member[static_cast<std::size_t>(c) + 1];
  std::partial_sum(result.first_member.begin(), result.first_member.end(), result.first_member.begin());
  result.members.resize(result.class_of.size());
  std::vector<int> next = result.first_member;
  for (int node = 0; node < d.node_count(); ++node)
    result.members[static_cast<std::size_t>(
        next[static_cast<std::size_t>(result.class_of[static_cast<std::size_t>(node)])]++)] = node;
  return result;
}

}  // namespace isopatch::iga
