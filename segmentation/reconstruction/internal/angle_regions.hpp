#pragma once

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/reconstruction_options.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Regions by the angles between triangles: grown across edges below the cutoff; the large ones once more
/// with the inner cutoff; the small ones, smallest first, given to the neighbour with the smallest mean angle
/// between. A carrier is looked for in each.
/// @param tolerance  of the carriers, m
/// @source  The isogeometric segmentation pipeline, section 2
Regions angle_regions(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                      double tolerance, const ReconstructionOptions& options);

}  // namespace isopatch::segmentation
