#pragma once

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Whether a curve is one segment.
bool is_segment(const geometry::NurbsCurve& curve);

/// The straight blend from one curve over [0, 1] to another, exact at both up to round-off of their knots:
/// those that agree to 1e-9 count as one.
geometry::NurbsSurface straight_wall(const geometry::NurbsCurve& below, const geometry::NurbsCurve& above);

}  // namespace isopatch::segmentation
