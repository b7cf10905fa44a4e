#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/cutting/cell_geometry.hpp"

namespace isopatch::segmentation {

/// A surface through a closed walk of edges, and what it adds to the edges' curves.
struct CuttingSurface {
  geometry::CellSurface surface;  ///< the walk runs counter-clockwise around it
  /// Curves in its domain, by edge of the walk; none on a plane.
  std::vector<geometry::NurbsCurve> traces;
};

/// The surface through a walk: the plane that it lies in, or the Coons patch of its four sides.
/// @param walk  edges one after the other, as the surface has them around it
/// @param tolerance  m
/// @return  nothing for a walk that is neither plane nor of four edges
std::optional<CuttingSurface> cutting_surface(const CellGeometry& geometry,
                                              const std::vector<geometry::EdgeUse>& walk, double tolerance);

}  // namespace isopatch::segmentation
