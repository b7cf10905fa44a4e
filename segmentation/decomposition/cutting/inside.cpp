#include "segmentation/decomposition/cutting/inside.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/brep/cell_solids.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

namespace {

Eigen::Matrix3Xd columns(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = points[i];
  return result;
}

Eigen::Matrix3Xd fans(const CellShapes& shapes, geometry::CellId cell) {
  const geometry::CellComplex& complex = shapes.complex();
  std::vector<Eigen::Vector3d> points;
  for (const geometry::CellFaceUse& face : complex.cell(cell).faces) {
    const auto& loop = complex.face(face.face).loop;
    const Eigen::Vector3d& first = complex.vertex(complex.from(loop.front()));
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      points.push_back(first);
      points.push_back(complex.vertex(complex.from(loop[i])));
      points.push_back(complex.vertex(complex.to(loop[i])));
      if (face.reversed) std::swap(points.back(), points[points.size() - 2]);
    }
  }
  return columns(points);
}

}  // namespace

Eigen::Matrix3Xd boundary_triangles(const CellShapes& shapes, geometry::CellId cell) {
  if (is_polyhedral(shapes, cell)) return fans(shapes, cell);
  const geometry::Brep solid = cell_solids(shapes.source(), shapes.complex(), {cell}).front();
  std::vector<Eigen::Vector3d> points;
  for (const geometry::FaceTriangles& face :
       tessellate(solid, {.chord = triangles_off, .turn = Angle::degrees(20)}).faces)
    for (const auto& triangle : face.triangles.colwise())
      for (const int corner : triangle) points.emplace_back(face.points.col(corner));
  return columns(points);
}

double winding_number(const Eigen::Matrix3Xd& triangles, const Eigen::Vector3d& point) {
  double sum = 0;
  for (Eigen::Index i = 0; i < triangles.cols(); i += 3) {
    const Eigen::Vector3d a = triangles.col(i) - point, b = triangles.col(i + 1) - point,
                          c = triangles.col(i + 2) - point;
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

double distance_to(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& point) {
  double least = 1e300;
  for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
    const Eigen::Vector2d a = polygon.col(i), along = polygon.col((i + 1) % polygon.cols()) - a;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0;
    least = std::min(least, (point - a - share * along).norm());
  }
  return least;
}

Eigen::Matrix2Xd points_inside(const Eigen::Matrix2Xd& polygon, double wanted) {
  const Eigen::Vector2d low = polygon.rowwise().minCoeff(), extent = polygon.rowwise().maxCoeff() - low;
  // On the outline nothing is inside or outside.
  const double clear = std::max(wanted, 1e-6 * extent.norm());
  std::vector<Eigen::Vector2d> found;
  for (int n = 7; n <= 56 && found.size() < 20; n *= 2) {
    found.clear();
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Eigen::Vector2d at = low + extent.cwiseProduct(Eigen::Vector2d((i + 0.5) / n, (j + 0.5) / n));
        if (is_inside(polygon, at) && distance_to(polygon, at) > clear) found.push_back(at);
      }
  }
  if (found.empty() && wanted > 0) return points_inside(polygon);
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(found.size()));
  for (std::size_t i = 0; i < found.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = found[i];
  return result;
}

}  // namespace isopatch::segmentation
