#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

/// The steps of a closed walk, each of one or more edges one after the other.
using StepWalk = std::vector<std::vector<geometry::EdgeUse>>;
std::vector<geometry::EdgeUse> joined(const StepWalk& steps);

/// The plane that the points of a polygon, (3, n), m, lie in to `tolerance`; the polygon runs
/// counter-clockwise around it. Nothing for points on a line.
std::optional<geometry::PlaneSurface> plane_through(const Eigen::Matrix3Xd& points, double tolerance);

/// Points along a walk of edges, m: the start of each edge, and some more on curved ones; (3, n).
Eigen::Matrix3Xd points_along(const CellShapes& shapes, const std::vector<geometry::EdgeUse>& walk);

/// A surface through a closed walk of edges, and what it adds to the edges' curves.
struct CuttingSurface {
  geometry::CellSurface surface;  ///< the walk runs counter-clockwise around it
  /// Curves in its domain, by edge of the joined walk; none on a plane.
  std::vector<geometry::NurbsCurve> traces;
};

/// The surface through a walk: the plane that it lies in, or the Coons patch of its four steps, or one of
/// little bending over a plane.
/// @param tolerance  m, of planes; of patches a hundred times that, of those over a plane ten thousand times
/// @param any  whether walks in no plane may have other than four steps
/// @return  nothing where no surface is known, or a step of several edges has corners between
std::optional<CuttingSurface> cutting_surface(const CellShapes& shapes, const StepWalk& steps,
                                              double tolerance, bool any);

}  // namespace isopatch::segmentation
