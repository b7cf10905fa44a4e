#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// Side i of a triangle runs from its vertex i to the next.
struct TriangleSide {
  int triangle = -1;  ///< -1: none
  int side = 0;
  bool operator==(const TriangleSide&) const = default;
};

/// Which triangles lie beside each other. Of a closed mesh whose triangles agree, each side has one other.
struct MeshNeighbours {
  std::vector<std::array<TriangleSide, 3>>
      across;                      ///< by triangle and side; none where it is not one that runs the other way
  std::vector<TriangleSide> open;  ///< sides without another triangle
  std::vector<TriangleSide> overused;  ///< a side of each edge with more than two triangles
  std::vector<TriangleSide> against;   ///< a side of each edge that two triangles walk in one direction
  bool closed() const { return open.empty() && overused.empty() && against.empty(); }
};

/// @cost  O(T log T)
MeshNeighbours neighbours(const TriangleMesh& mesh);

}  // namespace isopatch::geometry
