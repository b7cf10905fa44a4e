#pragma once

#include <array>
#include <vector>

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/branches/internal/plan_view.hpp"

namespace isopatch::segmentation {

/// A face across a column, counterclockwise as seen along its view.
struct ColumnLayer {
  FaceId face;
  std::array<VertexId, 4> corners;
  std::array<geometry::EdgeUse, 4> sides;  ///< from each corner to the next
};

/// Hexahedra of a complex one below the other.
struct Column {
  std::vector<ColumnLayer> layers;                          ///< from the top
  std::vector<geometry::CellId> cells;                      ///< between two layers each
  std::vector<std::array<geometry::CellFaceUse, 4>> walls;  ///< of each cell, by side
  std::vector<std::array<geometry::EdgeUse, 4>> uprights;   ///< of each cell, by corner, upwards
};

/// The column below an outer face with given corners.
/// @throws Error unsupported  no such face is a side of one hexahedron: says where
Column column_below(const geometry::CellComplex& complex, const PlanView& view,
                    const std::array<Eigen::Vector3d, 4>& corners, double tolerance);

}  // namespace isopatch::segmentation
