#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// A part of a solid between planes.
struct Piece {
  geometry::Brep brep;
  /// By face: that of the whole solid; nothing where a plane has cut.
  std::vector<std::optional<FaceId>> origin;
  SweepFrame frame;     ///< along which it is most like a stack
  bool turned = false;  ///< it is no stack, but turned
  int faults = 0;       ///< what keeps it from being either, 0 where it is one
};

/// A part of a solid, seen along the direction along which it is most like a stack.
/// @param origin  see `Piece`
/// @cost  that of `is_stack` for each direction
Piece seen(geometry::Brep brep, std::vector<std::optional<FaceId>> origin);

/// Faces that a plane has made.
std::vector<FaceId> cut_faces(const Piece& piece);

/// As the carrier says, looking out of the piece.
geometry::PlaneSurface plane_of(const geometry::Brep& brep, FaceId face);

}  // namespace isopatch::segmentation
