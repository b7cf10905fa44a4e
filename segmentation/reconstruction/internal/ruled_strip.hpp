#pragma once

#include <array>
#include <optional>

#include "geometry/splines/nurbs.hpp"
#include "segmentation/reconstruction/internal/wireframe.hpp"

namespace isopatch::segmentation {

/// A freeform face that is straight from one plane to a parallel one: its two long edges are splines over the
/// same knots, its ends are lines.
struct RuledStrip {
  /// u along the planes, v from one to the other, its normal outward.
  geometry::NurbsSurface surface;
  std::array<int, 4> edges;                    ///< of the wireframe
  std::array<geometry::NurbsCurve, 4> curves;  ///< each from its edge's start to its end
};

/// What a region is if its four edges and the vertices inside of it allow that.
///
/// Equal shares of the two long edges' lengths belong together, unless vertices inside say otherwise
/// (`slide_rulings`). Walls at right angles to the planes become that exactly.
/// @param tolerance  of vertices' distances from the long edges, m
/// @return nothing for other regions
/// @cost  that of `slide_rulings`
std::optional<RuledStrip> ruled_strip(const geometry::TriangleMesh& mesh,
                                      const geometry::MeshNeighbours& neighbours, const Wireframe& wires,
                                      const Regions& regions, int region, double tolerance);

}  // namespace isopatch::segmentation
