#pragma once

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The flat quadrilateral between two curves: direction 1 runs straight from `inner` to `outer`, direction 2
/// along them. Curves that run anticlockwise about +z, seen from inside, give a surface with its normal along
/// +z.
NurbsSurface section_between(const NurbsCurve& inner, const NurbsCurve& outer);

}  // namespace isopatch::geometry
