#pragma once

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// What `weld` did.
struct Welded {
  TriangleMesh mesh;
  int vertices = 0;    ///< that were merged into others
  int degenerate = 0;  ///< triangles left out since two of their vertices became one
};

/// Vertices nearer to each other than the tolerance become one, that of the lowest number; triangles and
/// vertices that are not needed any more go.
/// @param tolerance  in the mesh's unit; 0: only equal ones
/// @throws Error invalid_argument  negative or NaN
/// @cost  O(V log V)
Welded weld(const TriangleMesh& mesh, double tolerance);

}  // namespace isopatch::geometry
