#pragma once

#include <Eigen/Core>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <functional>
#include <optional>

#include "geometry/brep/brep_parts.hpp"

namespace isopatch::geometry {

/// A surface as a plane, cylinder, cone, sphere or torus.
struct SurfaceForm {
  Handle(Geom_Surface) surface;
  /// From a point of the old domain to the point of the new one that is there in space; steady over all of
  /// the domain, so that the two sides of a seam are a turn apart.
  std::function<Eigen::Vector2d(const Eigen::Vector2d&)> to_domain;
  bool turned = false;  ///< whether S_u x S_v points to the other side than before
};

/// What a surface is over a box of its domain; nothing if it is off by more than the tolerance somewhere.
/// @param tolerance  units of the surface
std::optional<SurfaceForm> surface_form(const Handle(Geom_Surface) & surface, const DomainBox& box,
                                        double tolerance);

/// A curve as a line, circle or ellipse from its first point to its last.
struct CurveForm {
  Handle(Geom_Curve) curve;
  double first = 0, last = 0;
  std::function<double(double)> to_parameter;  ///< from the old curve's
};
std::optional<CurveForm> curve_form(const Handle(Geom_Curve) & curve, double first, double last,
                                    double tolerance);

}  // namespace isopatch::geometry
