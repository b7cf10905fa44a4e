#pragma once

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/internal/facets.hpp"

namespace isopatch::segmentation {

/// Joins small facets that are flaws of a large plane facet to it.
///
/// A flaw lies within `tolerance` of the plane, and turns away from it by a small share of the angle by which
/// what lies behind it does (the first strip of a round turns by as much as the next); or it lies around a
/// single vertex that is off the plane.
/// @param tolerance  m
/// @cost  O(T log T)
Facets without_dents(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                     Facets facets, double tolerance);

}  // namespace isopatch::segmentation
