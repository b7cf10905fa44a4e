#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Regions whose planes of a few triangles that are flat by chance belong to the freeform face around: those
/// no larger than its triangles, and those not much larger whose smooth border with it is bent, as no such
/// face of a few triangles has one.
///
/// @param smooth     largest angle between neighbouring triangles of one curved surface
/// @param tolerance  of straight borders, m
/// @cost  O(T)
Regions without_chance_planes(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                              Regions regions, Angle smooth, double tolerance);

}  // namespace isopatch::segmentation
