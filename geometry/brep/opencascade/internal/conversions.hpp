#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

inline Eigen::Vector3d to_eigen(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}
inline Eigen::Vector3d to_eigen(const gp_Vec& p) {
  return {p.X(), p.Y(), p.Z()};
}
inline Eigen::Vector3d to_eigen(const gp_Dir& p) {
  return {p.X(), p.Y(), p.Z()};
}
inline Eigen::Vector2d to_eigen(const gp_Pnt2d& p) {
  return {p.X(), p.Y()};
}
inline gp_Pnt to_point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

/// @param scale  that the coordinates are multiplied with
Handle(Geom_BSplineSurface) to_shape(const NurbsSurface& surface, double scale);
Handle(Geom_BSplineCurve) to_shape(const NurbsCurve& curve, double scale);
/// The curve's (u, v).
Handle(Geom2d_BSplineCurve) to_domain_curve(const NurbsCurve& curve);
/// @param curve  not periodic
NurbsCurve to_nurbs(const Geom_BSplineCurve& curve, double scale);
/// @param surface  not periodic
NurbsSurface to_nurbs(const Geom_BSplineSurface& surface, double scale);
/// In the plane z = 0. @param curve  not periodic
NurbsCurve to_nurbs(const Geom2d_BSplineCurve& curve);

}  // namespace isopatch::geometry
