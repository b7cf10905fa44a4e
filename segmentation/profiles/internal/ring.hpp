#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/curve.hpp"

namespace isopatch::segmentation::planar {

/// How far a point may go from a corner of an outline and still have nearly nothing else of it nearer than
/// the corner's own sides.
/// @param way of length 1
/// @param half_angle between it and the sides, radians
/// @param outline points of it, dense
/// @return infinity where nothing is in the way
double room_along(const Eigen::Vector2d& corner, const Eigen::Vector2d& way, double half_angle,
                  const std::vector<Eigen::Vector2d>& outline);

/// A ring of quadrilaterals inside the outline of a mesh of one region, around triangles: where to begin with
/// a smooth outline. They may be folded.
/// @param shared of each curve: whether there are wanted regions on both its sides
/// @return nothing where there are holes, sides not shared, or few corners that are nearly straight
std::optional<CellMesh> ring_start(const std::vector<Curve>& curves, const CellMesh& region,
                                   const std::vector<bool>& shared);

/// Likewise around quadrilaterals, for outlines of 4 to 8 corners: all ways to divide what the ring leaves,
/// twice, with rings of two widths.
std::vector<CellMesh> rings_around_quads(const std::vector<Curve>& curves, const CellMesh& region,
                                         const std::vector<bool>& shared);

}  // namespace isopatch::segmentation::planar
