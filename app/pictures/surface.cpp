#include "app/pictures/surface.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace isopatch::app {
namespace {

constexpr double cosine_of_sharp = 0.866;  // 30 degrees

/// Points by place. Equal points differ by round-off, so the lattice, far coarser than that, is shifted to
/// lie askew of the round numbers that models are made of.
class Places {
 public:
  explicit Places(const Eigen::Matrix3Xd& points) {
    if (points.cols() == 0) return;
    low_ = points.rowwise().minCoeff();
    step_ = 1e-6 * (points.rowwise().maxCoeff() - low_).norm();
    for (int i = 0; i < points.cols(); ++i) here_[key(points.col(i))].push_back(i);
  }
  const std::vector<int>& at(const Eigen::Vector3d& point) const { return here_.at(key(point)); }

 private:
  std::uint64_t key(const Eigen::Vector3d& point) const {
    if (!(step_ > 0)) return 0;
    std::uint64_t result = 0;
    for (int d = 0; d < 3; ++d)  // below 2^21 cells a direction
      result = (result << 21) + static_cast<std::uint64_t>((point[d] - low_[d]) / step_ + 0.3819660113);
    return result;
  }
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  double step_ = 0;
  std::unordered_map<std::uint64_t, std::vector<int>> here_;
};

double angle_at(const Surface& surface, const std::array<int, 3>& triangle, std::size_t corner) {
  const Eigen::Vector3d origin = surface.points.col(triangle[corner]);
  const Eigen::Vector3d first = surface.points.col(triangle[(corner + 1) % 3]) - origin;
  const Eigen::Vector3d second = surface.points.col(triangle[(corner + 2) % 3]) - origin;
  return std::atan2(first.cross(second).norm(), first.dot(second));
}

/// At each point the sum over its own triangles. Each counts by its angle, so that it does not matter how
/// quadrilaterals were divided.
Eigen::Matrix3Xd own_normals(const Surface& surface) {
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, surface.points.cols());
  for (const auto& triangle : surface.triangles) {
    const Eigen::Vector3d normal = area_vector(surface, triangle).normalized();
    for (std::size_t c = 0; c < 3; ++c) sums.col(triangle[c]) += angle_at(surface, triangle, c) * normal;
  }
  return sums;
}

Eigen::Matrix3Xd beside(const Eigen::Matrix3Xd& first, const Eigen::Matrix3Xd& second) {
  Eigen::Matrix3Xd both(3, first.cols() + second.cols());
  both << first, second;
  return both;
}

}  // namespace

Eigen::Vector3d area_vector(const Surface& surface, const std::array<int, 3>& triangle) {
  const Eigen::Vector3d origin = surface.points.col(triangle[0]);
  return (surface.points.col(triangle[1]) - origin).cross(surface.points.col(triangle[2]) - origin);
}

Eigen::Matrix3Xd smooth_normals(const Surface& surface) {
  const Places places(surface.points);
  const Eigen::Matrix3Xd own = own_normals(surface);
  Eigen::Matrix3Xd result(3, own.cols());
  for (int i = 0; i < own.cols(); ++i) {
    const Eigen::Vector3d direction = own.col(i).normalized();
    Eigen::Vector3d sum = own.col(i);
    for (const int j : places.at(surface.points.col(i)))
      if (j != i && direction.dot(own.col(j).normalized()) > cosine_of_sharp) sum += own.col(j);
    result.col(i) = sum.normalized();
  }
  return result;
}

Surface joined(const Surface& first, const Surface& second) {
  Surface result;
  result.points = beside(first.points, second.points);
  result.undeformed = beside(first.undeformed, second.undeformed);
  result.normals = beside(first.normals, second.normals);
  result.values.resize(first.values.size() + second.values.size());
  result.values << first.values, second.values;
  result.triangles = first.triangles;
  const auto offset = static_cast<int>(first.points.cols());
  for (const auto& t : second.triangles)
    result.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return result;
}

Lines joined(const Lines& first, const Lines& second) {
  Lines result{beside(first.points, second.points), beside(first.undeformed, second.undeformed),
               first.segments};
  const auto offset = static_cast<int>(first.points.cols());
  for (const auto& s : second.segments) result.segments.push_back({s[0] + offset, s[1] + offset});
  return result;
}

}  // namespace isopatch::app
