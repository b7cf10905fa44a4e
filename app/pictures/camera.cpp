#include "app/pictures/camera.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

const std::array<std::pair<const char*, Eigen::Vector3d>, 7>& directions() {
  static const std::array<std::pair<const char*, Eigen::Vector3d>, 7> all = {{{"iso", {0.5, -0.9, 0.7}},
                                                                              {"front", {0, -1, 0}},
                                                                              {"back", {0, 1, 0}},
                                                                              {"left", {-1, 0, 0}},
                                                                              {"right", {1, 0, 0}},
                                                                              {"top", {0, 0, 1}},
                                                                              {"bottom", {0, 0, -1}}}};
  return all;
}

}  // namespace

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const auto& [name, direction] : directions()) names.emplace_back(name);
  return names;
}

std::optional<View> named_view(const std::string& name) {
  for (const auto& [known, direction] : directions())
    if (name == known) return view_from(direction, std::nullopt);
  return std::nullopt;
}

View view_from(const Eigen::Vector3d& toward_eye, const std::optional<Eigen::Vector3d>& up) {
  if (!(toward_eye.norm() > 0))
    throw Error(ErrorCode::invalid_argument, "a view needs a direction, got (0, 0, 0)");
  View view;
  view.toward_eye = toward_eye.normalized();
  const bool along_z = std::abs(view.toward_eye.z()) > 0.9999;
  const Eigen::Vector3d wanted = up.value_or(along_z ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d right = wanted.cross(view.toward_eye);
  if (!(right.norm() > 1e-6 * wanted.norm()))
    throw Error(ErrorCode::invalid_argument, "what points upwards must not lie along the view");
  view.right = right.normalized();
  view.up = view.toward_eye.cross(view.right);
  return view;
}

Eigen::Vector2d pixel(const Camera& camera, const Eigen::Vector3d& point, const PictureSize& size) {
  const Eigen::Vector3d from_focus = point - camera.focus;
  const Eigen::Vector2d flat(camera.view.right.dot(from_focus), camera.view.up.dot(from_focus));
  return size.height / camera.height * flat + 0.5 * Eigen::Vector2d(size.width, size.height);
}

Camera fitted(const View& view, const Eigen::Matrix3Xd& points, const Layout& layout, double zoom) {
  Eigen::Matrix<double, 2, 3> axes;
  axes.row(0) = view.right;
  axes.row(1) = view.up;
  const Eigen::Matrix2Xd flat = axes * points;
  const Eigen::Vector2d low = flat.rowwise().minCoeff();
  const Eigen::Vector2d high = flat.rowwise().maxCoeff();
  const Eigen::Vector2d extent = (high - low).cwiseMax(1e-12 * (1 + high.norm()));
  const Eigen::Vector2d room(layout.part.right - layout.part.left, layout.part.top - layout.part.bottom);
  const double pixels = zoom * (room.array() / extent.array()).minCoeff();  // per model unit
  const Eigen::Vector2d middle(0.5 * (layout.part.left + layout.part.right),
                               0.5 * (layout.part.bottom + layout.part.top));
  const Eigen::Vector2d centre(0.5 * layout.size.width, 0.5 * layout.size.height);
  const Eigen::Vector2d focus = 0.5 * (low + high) - (middle - centre) / pixels;
  const Eigen::Vector3d depth = 0.5 * (points.rowwise().minCoeff() + points.rowwise().maxCoeff());
  return {view, axes.transpose() * focus + view.toward_eye * view.toward_eye.dot(depth),
          layout.size.height / pixels};
}

}  // namespace isopatch::app
