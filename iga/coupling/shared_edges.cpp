#include "iga/coupling/shared_edges.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace isopatch::iga {
namespace {

constexpr double round_off = 1e-12;

// The nodes of a face as a grid, and who else has a say in their displacements.
class FaceGrid {
 public:
  FaceGrid(const geometry::PatchFace& face, const std::vector<geometry::PatchFace>& slaves,
           const Discretization& discretization, const GlobalNodes& global,
           const std::vector<SupportFrame>& frames)
      : global_(global), frames_(frames) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    const std::array<int, 3> sizes = discretization.patches[p].sizes();
    const auto along = geometry::tangents(face.side);
    for (std::size_t d = 0; d < 2; ++d) size_[d] = sizes[static_cast<std::size_t>(along[d])];
    nodes_ = geometry::face_control_points(sizes, face.side);
    for (const geometry::PatchFace& other : slaves)
      if (other.patch == face.patch && other.side != face.side)
        for (const int node : geometry::face_control_points(sizes, other.side))
          of_other_slaves_.insert(discretization.first_node[p] + node);
    for (int& node : nodes_) node += discretization.first_node[p];
  }

  int size(std::size_t direction) const { return size_[direction]; }
  bool is_held_everywhere(int component) const {
    return std::all_of(nodes_.begin(), nodes_.end(), [&](int node) {
      const SupportFrame& frame = frame_of(node);
      return frame.axes.row(component).head(frame.free).isZero(round_off);
    });
  }
  bool is_shared(int i, int j, int component) const {
    const int node = nodes_[static_cast<std::size_t>(i + size_[0] * j)];
    return of_other_slaves_.contains(node) || global_.nodes_of(global_of(node)).size() > 1 ||
           free_axis_along(frame_of(node), component) < 0;
  }

 private:
  int global_of(int node) const { return global_.global_of[static_cast<std::size_t>(node)]; }
  const SupportFrame& frame_of(int node) const { return frames_[static_cast<std::size_t>(global_of(node))]; }

  const GlobalNodes& global_;
  const std::vector<SupportFrame>& frames_;
  std::array<int, 2> size_;
  std::vector<int> nodes_;
  std::set<int> of_other_slaves_;
};

SharedEdges shared_edges(const FaceGrid& grid, int component) {
  SharedEdges edges = {};
  const auto place = [&](std::size_t d, std::size_t end) { return end == 0 ? 0 : grid.size(d) - 1; };
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t end = 0; end < 2; ++end) {
      // Corners are those of other edges as well; where an edge has nothing else both count.
      const int count = grid.size(1 - d), corners = count > 2 ? 1 : 0;
      int shared = 0;
      for (int k = corners; k < count - corners; ++k)
        shared += d == 0 ? grid.is_shared(place(d, end), k, component)
                         : grid.is_shared(k, place(d, end), component);
      edges[d][end] = count > 2 ? shared > 0 : shared == count;
    }
  // Of a corner that is held alone one edge must give way.
  for (std::size_t u = 0; u < 2; ++u)
    for (std::size_t v = 0; v < 2; ++v)
      if (!edges[0][u] && !edges[1][v] && grid.is_shared(place(0, u), place(1, v), component))
        edges[0][u] = true;
  return edges;
}

}  // namespace

int free_axis_along(const SupportFrame& frame, int component) {
  for (int k = 0; k < frame.free; ++k)
    if (std::abs(frame.axes(component, k)) > 1 - round_off) return k;
  return -1;
}

std::array<std::optional<SharedEdges>, 3> shared_edges(const geometry::PatchFace& face,
                                                       const std::vector<geometry::PatchFace>& slaves,
                                                       const Discretization& discretization,
                                                       const GlobalNodes& global,
                                                       const std::vector<SupportFrame>& frames) {
  const FaceGrid grid(face, slaves, discretization, global, frames);
  std::array<std::optional<SharedEdges>, 3> result;
  for (int component = 0; component < 3; ++component)
    if (!grid.is_held_everywhere(component))
      result[static_cast<std::size_t>(component)] = shared_edges(grid, component);
  return result;
}

}  // namespace isopatch::iga
