#pragma once

#include <functional>
#include <optional>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// An edge of a solid as a rational curve, which polynomials only come near.
struct ExactCurve {
  geometry::NurbsCurve curve;          ///< over [0, 1], end weights 1, m
  std::function<double(double)> pace;  ///< from its parameter to the edge's t
};

/// The rational form of an arc of a circle or an ellipse: of degree 2, the middle weight the cosine of half
/// the angle, a double knot where an arc has more than 120 degrees, at equal angles. Of other rational edges
/// their own form, if its end weights can be made 1. Nothing for lines and polynomial curves.
///
/// Arcs over the same angle of the same cylinder, cone, sphere or torus have the same weights and parameters.
std::optional<ExactCurve> exact_curve(const geometry::Brep& brep, EdgeId edge);

ExactCurve reversed(const ExactCurve& exact);

}  // namespace isopatch::segmentation
