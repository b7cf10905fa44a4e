#include "geometry/mesh/mesh_neighbours.hpp"

#include <algorithm>

namespace isopatch::geometry {
namespace {

struct SideOfEdge {
  int low, high;
  TriangleSide at;
  bool rising;
};

std::vector<SideOfEdge> sorted_sides(const TriangleMesh& mesh) {
  std::vector<SideOfEdge> sides;
  sides.reserve(3 * static_cast<std::size_t>(mesh.triangles.cols()));
  for (int t = 0; t < mesh.triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int from = mesh.triangles(i, t), to = mesh.triangles((i + 1) % 3, t);
      sides.push_back({std::min(from, to), std::max(from, to), {t, i}, from < to});
    }
  std::sort(sides.begin(), sides.end(), [](const SideOfEdge& a, const SideOfEdge& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.at.triangle < b.at.triangle;
  });
  return sides;
}

}  // namespace

MeshNeighbours neighbours(const TriangleMesh& mesh) {
  MeshNeighbours result;
  result.across.resize(static_cast<std::size_t>(mesh.triangles.cols()));
  const std::vector<SideOfEdge> sides = sorted_sides(mesh);
  const auto other_of = [&](TriangleSide side) -> TriangleSide& {
    return result.across[static_cast<std::size_t>(side.triangle)][static_cast<std::size_t>(side.side)];
  };
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high)
      ++end;
    const SideOfEdge &a = sides[first], &b = sides[end - 1];
    if (end - first == 1) {
      result.open.push_back(a.at);
    } else if (end - first > 2) {
      result.overused.push_back(a.at);
    } else if (a.rising == b.rising) {
      result.against.push_back(a.at);
    } else {
      other_of(a.at) = b.at;
      other_of(b.at) = a.at;
    }
  }
  return result;
}

}  // namespace isopatch::geometry
