#pragma once

#include <array>
#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/turned/internal/core_strips.hpp"
#include "segmentation/turned/turned_request.hpp"

namespace isopatch::segmentation {

/// A half profile divided into quadrilaterals, without the column along the axis; distances from the axis and
/// heights, m.
struct TurnedDrawing {
  CoredProfile half;
  Quadrangulation quads;  ///< of a profile whose edges have the numbers of the half profile's curves
  std::vector<Eigen::Vector2d> places;  ///< of the quadrilaterals' vertices
  std::vector<geometry::NurbsCurve>
      curves;  ///< of their edges, exact, over [0, 1], in the half-plane at angle 0
  /// By strip: edges of the quadrilaterals beside the column, from low to high.
  std::vector<std::vector<int>> columns;
};

/// @param lines  in the ends of what is no whole turn, m: drawn as well
/// @throws Error unsupported  its outline is open, or it cannot be divided
TurnedDrawing turned_drawing(const geometry::Brep& solid, const TurnedFrame& frame,
                             const std::vector<std::array<Eigen::Vector3d, 2>>& lines,
                             const QuadrangulationOptions& options);

/// Of a whole turn, with rays drawn into its half profile.
/// @throws Error unsupported  as above, or a ray that meets nothing
TurnedDrawing turned_drawing(const geometry::Brep& solid, const TurnedFrame& frame,
                             const TurnedRequest& request, const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation
