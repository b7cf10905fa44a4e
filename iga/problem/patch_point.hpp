#pragma once

#include "geometry/base/ids.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::iga {

/// A place in a patch, with a weight.
struct PatchPoint {
  PatchId patch;
  geometry::Parameter<3> parameter = geometry::Parameter<3>::Zero();  ///< in the naming of the discretization
  double weight = 1;
};

}  // namespace isopatch::iga
