#include "segmentation/profiles/internal/standard_position.hpp"

#include <Eigen/Geometry>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;

StandardPosition standard_position(const Profile& profile) {
  Eigen::AlignedBox2d box;
  Vector2d along(1, 0);
  double longest = 0;
  for (const ProfileEdge& edge : profile.edges) {
    for (const Vector2d& point : edge.points) box.extend(point);
    const Vector2d line = edge.points.back() - edge.points.front();
    if (edge.points.size() != 2 || line.norm() <= longest * (1 + 1e-9)) continue;
    longest = line.norm();
    along = line / longest;
  }
  const double size = box.diagonal().norm();
  StandardPosition result{profile, box.center(), {}};
  result.axes.col(0) = size * along;
  result.axes.col(1) = size * Vector2d(-along.y(), along.x());
  const Eigen::Matrix2d into = result.axes.transpose() / (size * size);
  for (Vector2d& vertex : result.profile.vertices) vertex = into * (vertex - result.centre);
  for (ProfileEdge& edge : result.profile.edges)
    for (Vector2d& point : edge.points) point = into * (point - result.centre);
  return result;
}

}  // namespace isopatch::segmentation::planar
