#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// A mesh with regions whose walls meet their planes in edges, where rounds were between them.
struct WithoutRounds {
  geometry::TriangleMesh mesh;
  Regions regions;
  int removed = 0;                ///< rounds
  double volume_change = 0;       ///< of what the triangles bound, m^3
  std::vector<std::string> kept;  ///< sentences: which faces keep theirs, and why
};

/// Walls that run around between two parallel planes and are rounded along them, as those of milled pockets,
/// are extended to the planes. Of such a freeform region the triangles that reach from round to round are
/// kept; each of their vertices moves along the steepest way on the wall to the plane, and the plane goes on
/// to there.
///
/// @param mesh     closed
/// @param regions  planes with their carriers
/// @cost  O(T)
WithoutRounds without_rounds(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                             const Regions& regions);

}  // namespace isopatch::segmentation
