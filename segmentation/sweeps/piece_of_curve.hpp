#pragma once

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// A piece of an edge as an exact curve over [0, 1]: a segment, one rational quadratic arc of a circle or an
/// ellipse, or a piece of a spline.
/// @param low, high  in the edge's t; on a closed edge high may exceed 1
/// @throws Error unsupported  an arc of 170 degrees or more, a curve of no exact form
geometry::NurbsCurve piece_of_curve(const geometry::Brep& brep, EdgeId edge, double low, double high);

/// What a spline has between two shares of its parameters, 0 <= low < high <= 1: exact, over [0, 1].
geometry::NurbsCurve piece_of_curve(const geometry::NurbsCurve& whole, double low, double high);

}  // namespace isopatch::segmentation
