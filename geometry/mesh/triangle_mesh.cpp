#include "geometry/mesh/triangle_mesh.hpp"

#include <Eigen/Geometry>

namespace isopatch::geometry {

double diagonal(const TriangleMesh& mesh) {
  if (mesh.vertices.cols() == 0) return 0;
  return (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).norm();
}

Eigen::Vector3d area_vector(const TriangleMesh& mesh, Eigen::Index triangle) {
  const Eigen::Vector3d a = mesh.vertices.col(mesh.triangles(0, triangle));
  const Eigen::Vector3d to_b = mesh.vertices.col(mesh.triangles(1, triangle)) - a;
  const Eigen::Vector3d to_c = mesh.vertices.col(mesh.triangles(2, triangle)) - a;
  return to_b.cross(to_c);
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) sum += area_vector(mesh, t).norm() / 2;
  return sum;
}

double volume(const TriangleMesh& mesh) {
  if (mesh.triangles.cols() == 0) return 0;
  const Eigen::Vector3d middle = mesh.vertices.rowwise().mean();
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    sum += area_vector(mesh, t).dot(mesh.vertices.col(mesh.triangles(0, t)) - middle) / 6;
  return sum;
}

}  // namespace isopatch::geometry
