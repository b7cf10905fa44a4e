#pragma once

#include <optional>
#include <vector>

#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// A round between a floor and an upright wall: a piece of a torus about the direction of a stack or of a
/// cylinder across it.
struct Fillet {
  FaceId face;
  double radius;  ///< m
  Eigen::Vector3d
      tube;     ///< on the line through the centres of its sections: its height along the direction counts
  bool rises;   ///< its wall goes up from its floor, else down
  bool convex;  ///< it is on a rim; else in a corner
};

/// All faces of a solid that are neither across a direction nor along it, if they are such rounds; nothing
/// if other faces are among them, or none is there.
std::optional<std::vector<Fillet>> fillets(const geometry::Brep& solid, const Eigen::Vector3d& along);

}  // namespace isopatch::segmentation
