#include "geometry/collapse.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

std::array<int, 2> others(int along) {
  return tangents(side_of(along, false));
}

bool is_one_point(const Eigen::Matrix3Xd& points, const std::vector<int>& line, double tolerance) {
  for (const int i : line)
    if ((points.col(i) - points.col(line.front())).norm() > tolerance) return false;
  return true;
}

}  // namespace

std::array<PatchEdge, 12> all_edges() {
  std::array<PatchEdge, 12> edges;
  std::size_t count = 0;
  for (int along = 0; along < 3; ++along)
    for (const bool second : {false, true})
      for (const bool first : {false, true}) edges[count++] = {along, {first, second}};
  return edges;
}

std::vector<int> edge_control_points(const std::array<int, 3>& sizes, const PatchEdge& edge) {
  const std::array<int, 3> stride = {1, sizes[0], sizes[0] * sizes[1]};
  const auto along = static_cast<std::size_t>(edge.along);
  int start = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto d = static_cast<std::size_t>(others(edge.along)[k]);
    if (edge.high[k]) start += (sizes[d] - 1) * stride[d];
  }
  std::vector<int> result;
  for (int i = 0; i < sizes[along]; ++i) result.push_back(start + i * stride[along]);
  return result;
}

bool is_collapsed(const NurbsVolume& volume, const PatchEdge& edge, double tolerance) {
  return is_one_point(volume.control_points(), edge_control_points(volume.sizes(), edge), tolerance);
}

bool is_collapsed(const NurbsVolume& volume, Side side, int tangent_direction, double tolerance) {
  const auto [first, second] = tangents(side);
  if (tangent_direction != first && tangent_direction != second)
    throw Error(ErrorCode::invalid_argument, fmt::format("is_collapsed: direction {} does not run in side {}",
                                                         tangent_direction, name(side)));
  const std::vector<int> points = face_control_points(volume.sizes(), side);
  const int rows = volume.size(first);
  const int columns = volume.size(second);
  const bool along_first = tangent_direction == first;
  for (int line = 0; line < (along_first ? columns : rows); ++line) {
    std::vector<int> on_line;
    for (int i = 0; i < (along_first ? rows : columns); ++i)
      on_line.push_back(points[static_cast<std::size_t>(along_first ? i + line * rows : line + i * rows)]);
    if (!is_one_point(volume.control_points(), on_line, tolerance)) return false;
  }
  return true;
}

bool is_collapsed(const NurbsVolume& volume, Side side, double tolerance) {
  const auto [first, second] = tangents(side);
  return is_collapsed(volume, side, first, tolerance) || is_collapsed(volume, side, second, tolerance);
}

}  // namespace isopatch::geometry
