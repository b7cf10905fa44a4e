#pragma once

#include <optional>
#include <vector>

#include "segmentation/sweeps/internal/moving_drawing.hpp"

namespace isopatch::segmentation {

/// A hexahedron of a column over a quadrilateral.
struct Layer {
  int low, high;                      ///< numbers of levels
  std::optional<FaceId> bottom, top;  ///< of the solid, where it ends there
};

/// Columns of hexahedra over quadrilaterals.
struct Layers {
  std::vector<double> levels;               ///< heights, ascending, m
  std::vector<std::vector<Layer>> columns;  ///< by quadrilateral, from low to high
};

/// Divides what stands over each quadrilateral so that columns side by side meet in whole sides: at the
/// heights where a neighbour ends or is divided or a wall beside it changes its slope, and where asked.
/// @param asked      heights by quadrilateral; empty for none
/// @param tolerance  m, of heights that are one
Layers layers(const Quadrangulation& drawing, const std::vector<std::vector<Slab>>& slabs,
              const MovingDrawing& moving, const std::vector<std::vector<double>>& asked, double tolerance);

}  // namespace isopatch::segmentation
