#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Where the vertices of a region lie in a plane, all triangles counter-clockwise.
struct RegionMap {
  std::vector<int> vertices;  ///< of the mesh, each once
  Eigen::Matrix2Xd places;    ///< (2, vertices), m: lengths are about those of the region
};

/// A map of a region to the plane, holes included: to the plane that it faces, if all of it does; else its
/// outer border to a convex polygon that turns where it does, or to a circle, vertices inside by mean values
/// and holes by a vertex in the middle of each. Such maps to convex outlines have no fold.
/// @param corners  vertices of the mesh in which edges end
/// @return nothing for a region without a border, or one whose border touches itself
/// @cost  a sparse system of its vertices
/// @source Floater, Mean value coordinates, 2003, equation 2.1; Parametrization and smooth approximation of
/// surface triangulations, 1997, theorem 4.1 for the sense of convex outlines
std::optional<RegionMap> region_map(const geometry::TriangleMesh& mesh,
                                    const geometry::MeshNeighbours& neighbours, const Regions& regions,
                                    int region, const std::vector<int>& corners);

}  // namespace isopatch::segmentation
