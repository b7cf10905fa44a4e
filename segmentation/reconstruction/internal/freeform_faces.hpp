#pragma once

#include "segmentation/reconstruction/internal/wireframe.hpp"

namespace isopatch::segmentation {

/// Gives regions without a carrier their spline surfaces, and their edges their curves.
/// @param tolerance  of vertices' distances from curves, m
/// @throws Error unsupported  a region that no surface was found for, with its place
void add_freeform_faces(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                        Wireframe& wires, Regions& regions, double tolerance);

}  // namespace isopatch::segmentation
