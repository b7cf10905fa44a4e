#include "iga/coupling/shared_edges.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace isopatch::iga {

int free_axis_along(const SupportFrame& frame, int component) {
  constexpr double round_off = 1e-12;
  for (int k = 0; k < frame.free; ++k)
    if (std::abs(frame.axes(component, k)) > 1 - round_off) return k;
  return -1;
}

std::array<std::optional<SharedEdges>, 3> shared_edges(const geometry::PatchFace& face,
                                                       const std::vector<geometry::PatchFace>& slaves,
                                                       const Discretization& discretization,
                                                       const GlobalNodes& global,
                                                       const std::vector<SupportFrame>& frames) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  const std::array<int, 3> sizes = discretization.patches[p].sizes();
  const std::vector<int> nodes = geometry::face_control_points(sizes, face.side);
  const auto along = geometry::tangents(face.side);
  const std::array<int, 2> n = {sizes[static_cast<std::size_t>(along[0])],
                                sizes[static_cast<std::size_t>(along[1])]};
  std::set<int> of_others;  // nodes of the patch on other slave faces
  for (const geometry::PatchFace& other : slaves)
    if (other.patch == face.patch && other.side != face.side)
      for (const int node : geometry::face_control_points(sizes, other.side)) of_others.insert(node);
  const auto is_shared = [&](int i, int j, int component) {
    const int of_patch = nodes[static_cast<std::size_t>(i + n[0] * j)];
    if (of_others.contains(of_patch)) return true;
    const int node = discretization.first_node[p] + of_patch;
    const int c = global.global_of[static_cast<std::size_t>(node)];
    return global.nodes_of(c).size() > 1 ||
           free_axis_along(frames[static_cast<std::size_t>(c)], component) < 0;
  };
  const auto is_held = [&](int node, int component) {
    const int c = global.global_of[static_cast<std::size_t>(discretization.first_node[p] + node)];
    return free_axis_along(frames[static_cast<std::size_t>(c)], component) < 0 &&
           frames[static_cast<std::size_t>(c)]
               .axes.row(component)
               .head(frames[static_cast<std::size_t>(c)].free)
               .isZero(1e-12);
  };
  std::array<std::optional<SharedEdges>, 3> result;
  for (int component = 0; component < 3; ++component) {
    if (std::all_of(nodes.begin(), nodes.end(), [&](int node) { return is_held(node, component); })) continue;
    SharedEdges& edges = result[static_cast<std::size_t>(component)].emplace();
    for (std::size_t d = 0; d < 2; ++d)
      for (std::size_t end = 0; end < 2; ++end) {
        const int across = end == 0 ? 0 : n[d] - 1;
        const int count = n[1 - d];
        int shared = 0;
        // Corners are those of other edges as well; where an edge has nothing else both count.
        const int first = count > 2 ? 1 : 0;
        for (int k = first; k < count - first; ++k)
          shared += d == 0 ? is_shared(across, k, component) : is_shared(k, across, component);
        edges[d][end] = count > 2 ? shared > 0 : shared == count;
      }
  }
  return result;
}

}  // namespace isopatch::iga
