#pragma once

#include "geometry/base/progress.hpp"
#include "segmentation/reconstruction/internal/wireframe.hpp"

namespace isopatch::segmentation {

/// Gives regions without a carrier their spline surfaces, and their edges their curves: walls that are
/// straight from plane to plane by `ruled_strip`, others by `region_map` and `fit_surface`, trimmed by their
/// edges.
/// @param tolerance  of vertices' distances from curves and surfaces, m
/// @param size  of the model, m
/// @throws Error unsupported  a region without a surface that is nearer to its vertices than the chord error,
/// with its place
void add_freeform_faces(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                        Wireframe& wires, Regions& regions, double tolerance, double size,
                        const Progress& progress = {});

}  // namespace isopatch::segmentation
