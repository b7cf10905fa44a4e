#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// A mesh that bounds a solid, and what had to be done for it.
struct MendedMesh {
  TriangleMesh mesh;
  std::vector<std::string> remarks;  ///< sentences: "4 triangles that occur twice were left out"
};

/// What bounds one solid: vertices within the tolerance merged, triangles without area or that occur twice
/// left out, all turned so that neighbours agree and the outermost shell looks outwards, cavities inwards.
///
/// Remarks say all of it but the merging of vertices, which triangle files repeat for each triangle.
/// @param tolerance  in the mesh's unit
/// @throws Error not_manifold  edges of one or of three triangles, a surface with one side only, several
/// bodies: with the number of such places and one of them
/// @throws Error bad_format  no triangles
/// @cost  O(T log T)
MendedMesh mended(const TriangleMesh& mesh, double tolerance);

}  // namespace isopatch::geometry
