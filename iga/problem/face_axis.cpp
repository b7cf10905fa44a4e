#include "iga/problem/face_axis.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/larger.hpp"
#include "iga/problem/internal/face_quadrature.hpp"

namespace isopatch::iga {
namespace {

Eigen::Vector3d readable(const Eigen::Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  Eigen::Vector3d result = direction[largest] < 0 ? Eigen::Vector3d(-direction) : direction;
  for (int d = 0; d < 3; ++d)
    if (std::abs(std::abs(result[d]) - 1) < 1e-12) result = Eigen::Vector3d::Unit(d);
  return result;
}

}  // namespace

FaceAxis face_axis(const geometry::MultiPatch& model, const std::vector<geometry::PatchFace>& faces) {
  const std::vector<FacePoint> points = face_points(model.patches(), faces);
  FaceAxis axis;
  double area = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const FacePoint& point : points) {
    area += point.area;
    centroid += point.area * point.place;
    scatter += point.area * point.normal * point.normal.transpose();
  }
  centroid /= area;
  axis.direction = readable(symmetric_eigen(scatter).vectors.col(0));
  // A normal's line meets the axis where (x - point) . (axis x normal) = 0.
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const FacePoint& point : points) {
    const Eigen::Vector3d across = axis.direction.cross(point.normal);
    matrix += point.area * across * across.transpose();
    right += point.area * across * across.dot(point.place - centroid);
  }
  matrix += matrix.trace() * axis.direction * axis.direction.transpose();  // the point nearest the centroid
  const SymmetricEigen eigen = symmetric_eigen(matrix);
  constexpr double narrow = 1e-12;  // an arc of a millionth of a turn is a plane
  if (!(eigen.values[0] > narrow * eigen.values[2])) {
    axis.off = axis.tilt = std::numeric_limits<double>::infinity();
    return axis;
  }
  axis.point =
      centroid +
      eigen.vectors * Eigen::Vector3d((eigen.vectors.transpose() * right).cwiseQuotient(eigen.values));
  for (const FacePoint& point : points) {
    const Eigen::Vector3d across = axis.direction.cross(point.normal);
    axis.off = isopatch::larger(axis.off, std::abs(across.dot(point.place - axis.point)));
    axis.tilt = isopatch::larger(axis.tilt, std::abs(axis.direction.dot(point.normal)));
  }
  return axis;
}

}  // namespace isopatch::iga
