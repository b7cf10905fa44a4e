#pragma once

#include <Eigen/Core>

namespace isopatch::geometry {

/// A surface of triangles.
struct TriangleMesh {
  Eigen::Matrix3Xd vertices;   ///< (3, V)
  Eigen::Matrix3Xi triangles;  ///< (3, T), vertices counter-clockwise seen from outside
  /// Step of the coordinates in the file that they come from, in their unit: half of it is what they were
  /// rounded by.
  double grain = 0;
  bool operator==(const TriangleMesh& other) const {
    return grain == other.grain && vertices.cols() == other.vertices.cols() &&
           triangles.cols() == other.triangles.cols() && vertices == other.vertices &&
           triangles == other.triangles;
  }
};

/// Diagonal of the box of the vertices; 0 without any.
double diagonal(const TriangleMesh& mesh);
/// Of the triangles.
double area(const TriangleMesh& mesh);
/// Positive if the triangles are closed and run counter-clockwise seen from outside.
double volume(const TriangleMesh& mesh);
/// Twice the area, as a vector along the normal.
Eigen::Vector3d area_vector(const TriangleMesh& mesh, Eigen::Index triangle);

}  // namespace isopatch::geometry
