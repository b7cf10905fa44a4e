#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/base/angle.hpp"

namespace isopatch::geometry {

struct TessellationOptions {
  /// Largest distance between chords and the solid, as a share of its size. Range (0, 0.1).
  double chord = 1e-3;
  /// Largest angle between neighbouring chords. Range (0, 90 degrees].
  Angle turn = Angle::degrees(15);
};

/// Triangles of one face. Points on its edges are those of the neighbours, bit for bit.
struct FaceTriangles {
  Eigen::Matrix2Xd uv;         ///< of each point; points on a seam occur twice
  Eigen::Matrix3Xd points;     ///< m
  Eigen::Matrix3Xi triangles;  ///< counter-clockwise seen from outside
};

/// The points of one edge from its start to its end.
struct EdgePoints {
  Eigen::VectorXd t;        ///< increasing from 0 to 1
  Eigen::Matrix3Xd points;  ///< m
};

struct Tessellation {
  std::vector<FaceTriangles> faces;
  std::vector<EdgePoints> edges;
};

}  // namespace isopatch::geometry
