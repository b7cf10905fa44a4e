#include "iga/coupling/global_nodes.hpp"

#include <numeric>

#include "geometry/base/union_find.hpp"
#include "geometry/collapse.hpp"
#include "iga/spaces/matching_spaces.hpp"

namespace isopatch::iga {
namespace {

// Control points of collapsed edges, and of each line of a side along a direction in which it is collapsed.
void unite_collapsed(const geometry::MultiPatch& model, int patch, const std::array<int, 3>& sizes,
                     int offset, UnionFind& nodes) {
  const auto& original = model.patches()[static_cast<std::size_t>(patch)];
  const double tolerance = model.tolerance().same_point * model.size();
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

GlobalNodes global_nodes(const Discretization& d) {
  return global_nodes(d.model, sizes_of(d.patches));
}

GlobalNodes global_nodes(const geometry::MultiPatch& model, const std::vector<std::array<int, 3>>& sizes) {
  std::vector<int> first_node = {0};
  for (const auto& n : sizes) first_node.push_back(first_node.back() + n[0] * n[1] * n[2]);
  UnionFind nodes(first_node.back());
  for (const geometry::Interface& interface : model.interfaces()) {
    const int first = first_node[static_cast<std::size_t>(interface.first.patch.value)];
    const int second = first_node[static_cast<std::size_t>(interface.second.patch.value)];
    for (const auto& [i, j] : matching_control_points(interface, sizes)) nodes.unite(first + i, second + j);
  }
  for (int patch = 0; patch < model.patch_count(); ++patch)
    unite_collapsed(model, patch, sizes[static_cast<std::size_t>(patch)],
                    first_node[static_cast<std::size_t>(patch)], nodes);

  GlobalNodes result;
  result.global_of.resize(static_cast<std::size_t>(first_node.back()));
  int count = 0;
  for (int node = 0; node < first_node.back(); ++node) {
    const int root = nodes.find(node);
    result.global_of[static_cast<std::size_t>(node)] =
        root == node ? count++ : result.global_of[static_cast<std::size_t>(root)];
  }
  result.first_member.assign(static_cast<std::size_t>(count) + 1, 0);
  for (const int c : result.global_of) ++result.first_member[static_cast<std::size_t>(c) + 1];
  std::partial_sum(result.first_member.begin(), result.first_member.end(), result.first_member.begin());
  result.members.resize(result.global_of.size());
  std::vector<int> next = result.first_member;
  for (int node = 0; node < first_node.back(); ++node)
    result.members[static_cast<std::size_t>(
        next[static_cast<std::size_t>(result.global_of[static_cast<std::size_t>(node)])]++)] = node;
  return result;
}

}  // namespace isopatch::iga
