#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Regions where surfaces go over into freeform faces without a corner: two faces alone have none along a
/// smooth border. Facets of the surface at such a corner lie on it by chance and are given to the freeform
/// face, if fewer corners are left then: one that moves on instead is where the surface ends.
///
/// @param smooth  largest angle between neighbouring triangles of one curved surface
/// @cost  O(T log T)
Regions without_bent_borders(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                             Regions regions, Angle smooth);

}  // namespace isopatch::segmentation
