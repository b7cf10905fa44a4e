#pragma once

#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"
#include "segmentation/reconstruction/regularity.hpp"

namespace isopatch::segmentation {

/// Axes and normals that agree but for the tolerance become parallel or perpendicular, axes coaxial, radii
/// equal; carriers are fitted again under these conditions, which are kept where all vertices stay within
/// three tolerances.
/// @param tolerance  m
Regularity regularise(const geometry::TriangleMesh& mesh, Regions& regions, double tolerance);

}  // namespace isopatch::segmentation
