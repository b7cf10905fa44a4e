#pragma once

#include <string>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A piece of a surface, cut out by closed loops of curves in its domain.
struct TrimmedSurface {
  std::string name;
  NurbsSurface surface;
  /// Each loop's curves follow one another; outer loop first. Points are (u, v, 0). A loop's sense does not
  /// matter.
  std::vector<std::vector<NurbsCurve>> loops;
};

}  // namespace isopatch::geometry
