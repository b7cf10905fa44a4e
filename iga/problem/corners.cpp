#include "iga/problem/corners.hpp"

namespace isopatch::iga {

std::array<PatchCorner, 8> corners_of(PatchId patch) {
  std::array<PatchCorner, 8> result;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {patch, {(i & 1u) != 0, (i & 2u) != 0, (i & 4u) != 0}};
  return result;
}

int control_point_of(const std::array<int, 3>& sizes, const PatchCorner& corner) {
  int index = 0, stride = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    if (corner.high[d]) index += stride * (sizes[d] - 1);
    stride *= sizes[d];
  }
  return index;
}

int node_of(const Discretization& d, const PatchCorner& corner) {
  const auto p = static_cast<std::size_t>(corner.patch.value);
  return d.first_node[p] + control_point_of(d.patches[p].sizes(), corner);
}

Eigen::Vector3d place_of(const Discretization& d, const PatchCorner& corner) {
  const auto p = static_cast<std::size_t>(corner.patch.value);
  return d.patches[p].control_points().col(control_point_of(d.patches[p].sizes(), corner));
}

}  // namespace isopatch::iga
