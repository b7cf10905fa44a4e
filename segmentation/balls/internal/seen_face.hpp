#pragma once

#include <Eigen/Core>

#include "geometry/brep/brep.hpp"
#include "segmentation/balls/internal/ball_frame.hpp"

namespace isopatch::segmentation {

/// The only face of a solid as it is seen from the middle.
class SeenFace {
 public:
  /// Both must outlive it.
  SeenFace(const geometry::Brep& solid, const BallFrame& frame) : solid_(solid), frame_(frame) {}

  /// Where the ray from the middle through a point of the frame's ellipsoid meets the face, m, to 1e-11 of
  /// the solid's size.
  /// @param on_sphere  of the unit sphere
  /// @throws Error unsupported  the ray meets it at less than 15 degrees, or nowhere that is found: names the
  /// place
  /// @source  Newton's method for the distance along the ray, with the tangent plane at the nearest point,
  /// between places known to be inside and outside
  Eigen::Vector3d point(const Eigen::Vector3d& on_sphere) const;

 private:
  const geometry::Brep& solid_;
  const BallFrame& frame_;
};

}  // namespace isopatch::segmentation
