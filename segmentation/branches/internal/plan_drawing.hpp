#pragma once

#include <array>
#include <vector>

#include "segmentation/branches/internal/outline.hpp"
#include "segmentation/profiles/quadrangulation.hpp"

namespace isopatch::segmentation {

/// A quadrilateral with outlines inside, divided further.
struct PlanDrawing {
  std::vector<PlanCurve> curves;  ///< of the drawing's edges: the four sides, those of outlines, other arcs
  std::vector<int> outline_of;    ///< by these curves: -1 of all others
  /// Its first four vertices are the corners, its first four edges the sides, from each corner to the next;
  /// `profile_edge` counts the curves.
  Quadrangulation quads;
  std::vector<int> around;  ///< by region: the outline just around it; -1: the frame around all

  /// Exact over [0, 1] in the plane z = 0.
  geometry::NurbsCurve curve(int edge) const;
};

/// By outline: the one just around it, or -1.
std::vector<int> nesting(const std::vector<Outline>& outlines);

/// A quadrilateral by its sides, counterclockwise, each over [0, 1] in the plane z = 0: lines and arcs, m.
using PlanQuad = std::array<geometry::NurbsCurve, 4>;

/// What is inside the outermost outline is divided first, as it is best (see `quadrangulate`); the frame
/// around it has a quadrilateral for each side, and three more where three pieces of the outline face that
/// side, so sides stay whole.
/// @param corners  counterclockwise, m
/// @param wanted   by outline: whether there is material anywhere just inside of it
/// @param inside   how what is inside is divided; empty for as it is best
/// @throws Error unsupported  several outermost outlines, what is inside cannot be divided, or is otherwise
PlanDrawing plan_drawing(const std::array<Eigen::Vector2d, 4>& corners, const std::vector<Outline>& outlines,
                         const std::vector<bool>& wanted, const std::vector<PlanQuad>& inside = {});

}  // namespace isopatch::segmentation
