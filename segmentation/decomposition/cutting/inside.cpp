#include "segmentation/decomposition/cutting/inside.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace isopatch::segmentation {

double winding_number(const geometry::Tessellation& boundary, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const geometry::FaceTriangles& face : boundary.faces)
    for (const auto& triangle : face.triangles.colwise()) {
      const Eigen::Vector3d a = face.points.col(triangle[0]) - point,
                            b = face.points.col(triangle[1]) - point,
                            c = face.points.col(triangle[2]) - point;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
  return sum / (2 * std::numbers::pi);
}

bool is_inside(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& point) {
  bool inside = false;
  const Eigen::Index n = polygon.cols();
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++) {
    const auto a = polygon.col(i), b = polygon.col(j);
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

Eigen::Matrix2Xd points_inside(const Eigen::Matrix2Xd& polygon) {
  const Eigen::Vector2d low = polygon.rowwise().minCoeff(), extent = polygon.rowwise().maxCoeff() - low;
  std::vector<Eigen::Vector2d> found;
  for (int n = 7; n <= 56 && found.size() < 20; n *= 2) {
    found.clear();
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Eigen::Vector2d at = low + extent.cwiseProduct(Eigen::Vector2d((i + 0.5) / n, (j + 0.5) / n));
        if (is_inside(polygon, at)) found.push_back(at);
      }
  }
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(found.size()));
  for (std::size_t i = 0; i < found.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = found[i];
  return result;
}

}  // namespace isopatch::segmentation
