#pragma once

#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Curve.hxx>
#include <vector>

namespace isopatch::geometry {

/// Parameters from first to last, both included, between which a curve is smooth and turns by a right angle
/// at most, if it is a conic. In descending order if first > last.
std::vector<double> smooth_ranges(const Handle(Geom_Curve) & curve, double first, double last);
std::vector<double> smooth_ranges(const Handle(Geom2d_Curve) & curve, double first, double last);

/// Directions of a surface's domain.
enum class Direction { u, v };

/// Parameters strictly between low and high at which a surface is not smooth: its knots.
std::vector<double> knots_between(const GeomAdaptor_Surface& surface, Direction direction, double low,
                                  double high);

/// Whether the parameter is an angle around an axis.
bool is_angle(const GeomAdaptor_Surface& surface, Direction direction);

}  // namespace isopatch::geometry
