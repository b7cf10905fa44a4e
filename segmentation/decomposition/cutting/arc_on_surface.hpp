#pragma once

#include <optional>

#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

/// An end of a curve on a surface: in its domain, and the point in space that it must run to, m.
struct CurveEnd {
  Eigen::Vector2d uv;
  Eigen::Vector3d point;
};

/// The circle or other conic in which a plane cuts a cylinder, cone, sphere or torus of the source, exact,
/// with its curve in the domain to `tolerance`.
/// @param by  a point of the domain, seen from the axis between the ends
/// @param tolerance  m
/// @return  nothing for other surfaces and where the section is straight or no conic (`conic_arc`)
/// @cost  some hundred nearest points of the surface
std::optional<geometry::CellCurve> arc_on_surface(const CellShapes& shapes, geometry::SurfaceId surface,
                                                  const geometry::PlaneSurface& plane, const CurveEnd& from,
                                                  const Eigen::Vector2d& by, const CurveEnd& to,
                                                  double tolerance);

}  // namespace isopatch::segmentation
