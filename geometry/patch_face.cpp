#include "geometry/patch_face.hpp"

namespace isopatch::geometry {

std::string_view name(Side side) {
  constexpr std::array<std::string_view, 6> names = {"west", "east", "south", "north", "front", "back"};
  return names[static_cast<std::size_t>(side)];
}

std::vector<int> face_control_points(const std::array<int, 3>& sizes, Side side) {
  const std::array<int, 3> stride = {1, sizes[0], sizes[0] * sizes[1]};
  const auto normal = static_cast<std::size_t>(direction(side));
  const auto first = static_cast<std::size_t>(tangents(side)[0]);
  const auto second = static_cast<std::size_t>(tangents(side)[1]);
  const int start = is_high(side) ? (sizes[normal] - 1) * stride[normal] : 0;
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(sizes[first]) * static_cast<std::size_t>(sizes[second]));
  for (int j = 0; j < sizes[second]; ++j)
    for (int i = 0; i < sizes[first]; ++i) result.push_back(start + i * stride[first] + j * stride[second]);
  return result;
}

NurbsSurface face_surface(const NurbsVolume& volume, Side side) {
  const std::vector<int> indices = face_control_points(volume.sizes(), side);
  const auto count = static_cast<Eigen::Index>(indices.size());
  Eigen::Matrix3Xd points(3, count);
  Eigen::VectorXd weights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.col(i) = volume.control_points().col(indices[static_cast<std::size_t>(i)]);
    weights[i] = volume.weights()[indices[static_cast<std::size_t>(i)]];
  }
  const auto [first, second] = tangents(side);
  return NurbsSurface({volume.knots(first), volume.knots(second)}, std::move(points), std::move(weights));
}

Parameter<3> on_side(const NurbsVolume& volume, Side side, const Parameter<2>& face_parameter) {
  Parameter<3> result;
  const KnotVector& across = volume.knots(direction(side));
  result[direction(side)] = is_high(side) ? across.last() : across.first();
  result[tangents(side)[0]] = face_parameter[0];
  result[tangents(side)[1]] = face_parameter[1];
  return result;
}

}  // namespace isopatch::geometry
