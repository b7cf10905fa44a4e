#include "segmentation/balls/internal/seen_face.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

constexpr double least_slope = 0.26;  // of the ray on the face: 15 degrees

[[noreturn]] void turns_away(const Eigen::Vector3d& place) {
  throw Error(
      ErrorCode::unsupported,
      fmt::format(
          "its face has an edge or a tip, or cannot be seen from the middle of the solid, near ({:.4g}, "
          "{:.4g}, "
          "{:.4g}) m; cut the solid there in the CAD program, so that each part is smooth and has no waist",
          place.x(), place.y(), place.z()));
}

}  // namespace

Eigen::Vector3d SeenFace::point(const Eigen::Vector3d& on_sphere) const {
  constexpr int most_steps = 60;
  constexpr FaceId face(0);
  const double close = 1e-11 * solid_.size();
  const Eigen::Vector3d way = frame_.point(on_sphere) - frame_.centre, along = way.normalized();
  double distance = way.norm(), inside = 0, outside = solid_.size();
  Eigen::Vector2d near;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::Vector3d guess = frame_.centre + distance * along;
    const geometry::FaceProjection foot =
        step == 0 ? solid_.project(face, guess) : solid_.project(face, guess, near);
    near = foot.uv;
    const Eigen::Vector3d normal = solid_.outward_normal(face, foot.uv);
    (normal.dot(guess - foot.point) > 0 ? outside : inside) = distance;
    const double slope = normal.dot(along);
    double next = normal.dot(foot.point - frame_.centre) / slope;
    if (!(slope > least_slope && next > inside - close && next < outside + close))
      next = (inside + outside) / 2;
    else if (foot.distance <= 100 * close && std::abs(next - distance) <= close)
      return frame_.centre + next * along;
    distance = next;
  }
  turns_away(frame_.centre + distance * along);
}

}  // namespace isopatch::segmentation
