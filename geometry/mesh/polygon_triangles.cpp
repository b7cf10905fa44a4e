#include "geometry/mesh/polygon_triangles.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

// Corners in one line are no fault.
constexpr double flat = 1e-6;

/// Twice the area as a vector.
Eigen::Vector3d polygon_area(const Eigen::Matrix3Xd& points, const std::vector<int>& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d start = points.col(polygon.front());
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (points.col(polygon[i]) - start).cross(points.col(polygon[i + 1]) - start);
  return sum;
}

/// The least sine of the corners of a triangle seen along the normal; negative if it is turned over.
double shape_of(const std::array<Eigen::Vector3d, 3>& p, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d a = p[1] - p[0], b = p[2] - p[1], c = p[0] - p[2];
  const double twice = a.cross(b).dot(normal);
  return twice / std::max({a.norm() * b.norm(), b.norm() * c.norm(), c.norm() * a.norm(), 1e-300});
}

bool covers(const std::array<Eigen::Vector3d, 3>& p, const Eigen::Vector3d& normal,
            const Eigen::Vector3d& point) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!((p[(i + 1) % 3] - p[i]).cross(point - p[i]).dot(normal) >= 0)) return false;
  return true;
}

}  // namespace

Eigen::Matrix3Xi polygon_triangles(const Eigen::Matrix3Xd& vertices, const std::vector<int>& polygon) {
  if (polygon.size() == 3) return Eigen::Vector3i(polygon[0], polygon[1], polygon[2]);
  std::vector<int> left = polygon;
  const Eigen::Vector3d normal = polygon_area(vertices, polygon).stableNormalized();
  Eigen::Matrix3Xi result(3, static_cast<Eigen::Index>(polygon.size()) - 2);
  const auto corners = [&](std::size_t i) {
    const std::size_t n = left.size();
    return std::array<Eigen::Vector3d, 3>{vertices.col(left[(i + n - 1) % n]), vertices.col(left[i]),
                                          vertices.col(left[(i + 1) % n])};
  };
  for (Eigen::Index next = 0; next < result.cols(); ++next) {
    const std::size_t n = left.size();
    double best = n == 3 ? -flat : 0;
    std::size_t ear = n;
    for (std::size_t i = 0; i < n; ++i) {
      const auto triangle = corners(i);
      const double shape = shape_of(triangle, normal);
      if (!(shape > best)) continue;
      bool free = true;
      for (std::size_t j = 0; j < n && free; ++j) {
        const Eigen::Vector3d point = vertices.col(left[j]);
        const bool own = point == triangle[0] || point == triangle[1] || point == triangle[2];
        free = own || !covers(triangle, normal, point);
      }
      if (!free) continue;
      best = shape;
      ear = i;
    }
    if (ear == n)
      throw Error(ErrorCode::bad_format,
                  fmt::format("a polygon of {} corners crosses itself", polygon.size()));
    result.col(next) << left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return result;
}

}  // namespace isopatch::geometry
