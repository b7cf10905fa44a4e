#pragma once

#include <utility>
#include <vector>

#include "geometry/quadrature.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// Corners of a polygon in the parameters of a surface, in their order; it need not be convex.
using ParameterPolygon = std::vector<Parameter<2>>;

/// Positive where the corners turn left.
double signed_area(const ParameterPolygon& polygon);

/// What is left of a polygon within a box; parts that fall apart stay joined by edges that run to and fro.
/// @source Sutherland, Hodgman 1974
ParameterPolygon clipped(ParameterPolygon polygon, const Parameter<2>& low, const Parameter<2>& high);

/// Quadrature points with their weights, which include the area in the parameters.
using PlanePoints = std::vector<std::pair<Parameter<2>, double>>;

/// The rule's points of a box.
PlanePoints box_points(const Parameter<2>& low, const Parameter<2>& high, const QuadratureRule& rule);

/// Points of a polygon: the rule's if it is a box, else those of triangles from its middle, for which bent
/// ones are halved until all of each part can be seen from there.
/// @param area  `signed_area` of it; not 0
/// @source for triangles: Duffy 1982
PlanePoints polygon_points(const ParameterPolygon& polygon, double area, const QuadratureRule& rule);

}  // namespace isopatch::geometry
