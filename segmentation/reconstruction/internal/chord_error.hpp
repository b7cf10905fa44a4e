#pragma once

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// How far the surface of a region is from its triangles at most, m: from the angles between neighbours and
/// their widths, as on a circle.
double chord_error(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                   const Regions& regions, int region);

}  // namespace isopatch::segmentation
