#pragma once

#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"

namespace isopatch::segmentation {

struct DividedQuads {
  Quadrangulation quads;    ///< vertices keep their numbers
  std::vector<int> parent;  ///< by quadrilateral: of which it is a part
};

/// Divides a side of a quadrilateral, the side opposite to it, and so on through all quadrilaterals on the
/// way until the outline is reached: they meet side to side as before. New sides run as those beside them do,
/// as chords or parabolas.
/// @param share  of the edge from its start, in (0, 1)
/// @cost linear in the quadrilaterals
DividedQuads divide_side(const Profile& profile, const Quadrangulation& quads, int edge, double share);

}  // namespace isopatch::segmentation
