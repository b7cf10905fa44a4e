#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/branches/internal/plan_curve.hpp"
#include "segmentation/branches/internal/plan_view.hpp"

namespace isopatch::segmentation {

/// A closed line of walls along a direction, seen along it.
struct Outline {
  std::vector<PlanCurve> curves;  ///< counterclockwise, each begins where the one before ends
  std::vector<FaceId> walls;      ///< planes, cylinders and freeform ones
  bool is_void = false;           ///< walls look inwards: a bore, a slot

  bool contains(const Eigen::Vector2d& point) const;
};

/// Whether a face is a plane or a cylinder along a direction.
bool is_wall(const geometry::Brep& solid, FaceId face, const Eigen::Vector3d& along);

/// Whether an edge is straight, splines among them, and along a direction.
bool is_straight_along(const geometry::Brep& solid, EdgeId edge, const Eigen::Vector3d& along);

/// Whether a face runs along a direction everywhere, whatever its surface is: its normals are across.
bool runs_along(const geometry::Brep& solid, FaceId face, const Eigen::Vector3d& along);

/// The outlines of walls; several over each other are one. Those of freeform walls are splines, to 1e-9 of
/// the solid's size.
/// @throws Error unsupported  a wall that ends beside no other, naming it
std::vector<Outline> outlines_of(const geometry::Brep& solid, const PlanView& view,
                                 const std::vector<FaceId>& walls);

}  // namespace isopatch::segmentation
