#pragma once

#include "segmentation/reconstruction/internal/wireframe.hpp"

namespace isopatch::segmentation {

/// Gives edges of freeform faces that have no curve yet smooth ones through the mesh's vertices along them:
/// between two freeform faces splines, beside a carrier many points of it.
/// @param tolerance  of vertices' distances from curves, m
/// @param size  of the model, m
void add_freeform_edges(Wireframe& wires, const Regions& regions, double tolerance, double size);

/// Points on the curve of a freeform face's edge, from its start to its end, closer together than the mesh's.
Eigen::Matrix3Xd points_along(const WireEdge& edge);

}  // namespace isopatch::segmentation
