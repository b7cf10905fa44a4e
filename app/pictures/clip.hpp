#pragma once

#include <vector>

#include "app/pictures/part_shape.hpp"

namespace isopatch::app {

/// Removes what lies beyond a plane across an axis, in the undeformed part.
struct Cut {
  int axis = 0;         ///< 0 .. 2
  double position = 0;  ///< what is kept lies below
};

/// The part of a surface, or of lines, that is kept.
Surface clipped(const Surface& surface, const Cut& cut);
Lines clipped(const Lines& lines, const Cut& cut);

/// Where the plane cuts a surface.
Lines cut_outline(const Surface& surface, const Cut& cut);

/// The plane's face of the cut part, with the values inside.
///
/// Each cell of the patches' grids counts as six tetrahedra, in which everything is linear.
/// Its normals are the axis', as if it were not deformed.
Surface section(const std::vector<PatchShape>& shape, const Cut& cut);

}  // namespace isopatch::app
