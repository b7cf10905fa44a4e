#pragma once

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Freeform regions that go around, with two loops, are divided across: where their longer loop turns most,
/// in two places at least, along edges of the mesh, the shortest way from loop to loop. Those with one loop
/// are where the spacing of its vertices changes four times and more at both ends of an edge across: there,
/// faces of different curvature met.
/// @cost  O(T log T)
Regions split_bands(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                    Regions regions);

}  // namespace isopatch::segmentation
