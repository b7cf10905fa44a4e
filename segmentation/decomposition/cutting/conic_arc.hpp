#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/brep/brep_parts.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// The arc in which a plane cuts a cylinder, a cone or a sphere, or a torus across or along its axis: exact,
/// a rational curve of degree 2 over [0, 1]. A wider arc than 120 degrees about the axis has double knots, at
/// equal angles.
///
/// End weights are 1; so arcs over the same angle of one cylinder have the same weights, and their
/// points of equal parameters lie on its rulings.
/// @param from  where it starts, m; `to` where it ends, `by` on the way, each in the plane and on the surface
/// @return  nothing where the plane has a ruling in it, or the section is no arc of one circle, ellipse,
/// parabola or branch of a hyperbola
std::optional<geometry::NurbsCurve> conic_arc(const geometry::Carrier& carrier,
                                              const geometry::PlaneSurface& plane,
                                              const Eigen::Vector3d& from, const Eigen::Vector3d& by,
                                              const Eigen::Vector3d& to);

}  // namespace isopatch::segmentation
