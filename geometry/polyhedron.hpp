#pragma once

#include <Eigen/Core>
#include <vector>

namespace isopatch::geometry {

/// A solid as points and polygons.
struct Polyhedron {
  Eigen::Matrix3Xd vertices;
  /// Vertices of each face in turn, from 0, counter-clockwise seen from outside.
  std::vector<std::vector<int>> faces;
};

}  // namespace isopatch::geometry
