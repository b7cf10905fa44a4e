#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

/// The steps of a closed walk, each of one or more edges one after the other.
using StepWalk = std::vector<std::vector<geometry::EdgeUse>>;
std::vector<geometry::EdgeUse> joined(const StepWalk& steps);

/// A surface through a closed walk of edges, and what it adds to the edges' curves.
struct CuttingSurface {
  geometry::CellSurface surface;  ///< the walk runs counter-clockwise around it
  /// Curves in its domain, by edge of the joined walk; none on a plane.
  std::vector<geometry::NurbsCurve> traces;
};

/// The surface through a walk: the plane that it lies in, or the Coons patch of its four steps.
/// @param tolerance  m
/// @return  nothing for a walk that is neither plane nor of four steps, or a step of several edges with
/// corners between
std::optional<CuttingSurface> cutting_surface(const CellShapes& shapes, const StepWalk& steps,
                                              double tolerance);

}  // namespace isopatch::segmentation
