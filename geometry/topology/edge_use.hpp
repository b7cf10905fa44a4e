#pragma once

#include <compare>

#include "geometry/base/ids.hpp"

namespace isopatch::geometry {

/// An edge as a loop of a face walks it: from its start to its end, or reversed. The face lies to the left,
/// seen from outside the solid. An edge and a direction occur once on a face; a seam occurs in both
/// directions.
struct EdgeUse {
  EdgeId edge;
  bool reversed = false;
  auto operator<=>(const EdgeUse&) const = default;
};

}  // namespace isopatch::geometry
