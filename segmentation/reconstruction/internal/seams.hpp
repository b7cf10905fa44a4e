#pragma once

#include "segmentation/reconstruction/internal/wireframe.hpp"

namespace isopatch::segmentation {

/// Gives faces that go around their axis or tube a seam, and poles where it has to end in one: each loop is
/// closed in the carrier's domain then, and the edges' curves can be drawn there.
///
/// Axes of spheres are turned so that as few faces as possible have poles.
/// @param size  of the model, m
/// @throws Error unsupported  a face that goes around in a way without a rule, naming its place
void add_seams(Wireframe& wires, Regions& regions, const geometry::TriangleMesh& mesh, double size);

}  // namespace isopatch::segmentation
