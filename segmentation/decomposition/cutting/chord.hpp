#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

struct ChordOptions {
  double tolerance = 0;                ///< m
  Angle smallest = Angle::degrees(3);  ///< that it may make with the outline of a side at its ends
  bool bent = false;                   ///< where the straight way is not free, it may be bent
  /// That the edge is to lie in where it can: across a curved face, exact.
  std::optional<geometry::PlaneSurface> plane = {};
};

/// Puts an auxiliary edge across a side of a cell, in a plane if one is given, or straight in its domain:
/// along edges that are there already where it meets them, with new vertices where it crosses others. A bent
/// one crosses one face of the side.
/// @param side  faces on one surface, that continue each other
/// @return  its edges from `from` to `to`; nothing, and the complex as it was or divided in part, where it
/// leaves the side or comes too close to its outline
std::optional<std::vector<geometry::EdgeUse>> add_chord(const geometry::Brep& source,
                                                        geometry::CellComplex& complex,
                                                        const std::vector<FaceId>& side, VertexId from,
                                                        VertexId to, const ChordOptions& options);

}  // namespace isopatch::segmentation
