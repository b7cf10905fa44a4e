#pragma once

#include <array>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A surface divided into elements by lines of equal parameters.
struct DividedSurface {
  const NurbsSurface* surface = nullptr;      ///< must outlive this
  std::array<std::vector<double>, 2> breaks;  ///< between which the elements lie, per direction
};

}  // namespace isopatch::geometry
