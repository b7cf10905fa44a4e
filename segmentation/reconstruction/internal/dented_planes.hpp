#pragma once

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/internal/facets.hpp"

namespace isopatch::segmentation {

/// Facets with what is a flaw of a larger plane beside them joined to it: those within `tolerance` of it that
/// turn away by a small share of what lies behind them turns by, as the first strip of a round does not; and
/// those around one vertex that is off the plane, where all others are on it.
///
/// @param tolerance  m
/// @cost  O(T log T)
Facets without_dents(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                     Facets facets, double tolerance);

}  // namespace isopatch::segmentation
