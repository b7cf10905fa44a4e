#include "iga/coupling/shared_edges.hpp"

namespace isopatch::iga {

SharedEdges shared_edges(const geometry::PatchFace& face, const Discretization& discretization,
                         const GlobalNodes& global, const std::vector<SupportFrame>& frames) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  const std::array<int, 3> sizes = discretization.patches[p].sizes();
  const std::vector<int> nodes = geometry::face_control_points(sizes, face.side);
  const auto along = geometry::tangents(face.side);
  const std::array<int, 2> n = {sizes[static_cast<std::size_t>(along[0])],
                                sizes[static_cast<std::size_t>(along[1])]};
  const auto is_shared = [&](int i, int j) {
    const int node = discretization.first_node[p] + nodes[static_cast<std::size_t>(i + n[0] * j)];
    const int c = global.global_of[static_cast<std::size_t>(node)];
    return global.nodes_of(c).size() > 1 || frames[static_cast<std::size_t>(c)].free < 3;
  };
  SharedEdges result = {};
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t end = 0; end < 2; ++end) {
      const int across = end == 0 ? 0 : n[d] - 1;
      const int count = n[1 - d];
      int shared = 0;
      // Corners are those of other edges as well; where an edge has nothing else both count.
      const int first = count > 2 ? 1 : 0;
      for (int k = first; k < count - first; ++k)
        shared += d == 0 ? is_shared(across, k) : is_shared(k, across);
      result[d][end] = count > 2 ? shared > 0 : shared == count;
    }
  return result;
}

}  // namespace isopatch::iga
