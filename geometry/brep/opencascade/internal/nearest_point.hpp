#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

/// Points of a surface on a grid over a box of its domain, from which the search for nearest points starts.
struct SurfaceGrid {
  Eigen::Matrix2Xd uv;
  Eigen::Matrix3Xd points;  ///< units of the shape
};

/// A few points for each span of a spline, and for each eighth of a turn.
SurfaceGrid surface_grid(const Geom_Surface& surface, const DomainBox& box);

/// Parameters within the box, point and distance in units of the shape.
struct SurfacePoint {
  Eigen::Vector2d uv;
  Eigen::Vector3d point;
  double distance = 0;
};

/// The nearest point of a surface over a box: from the best points of the grid by Newton's method.
SurfacePoint nearest_point(const Geom_Surface& surface, const DomainBox& box, const SurfaceGrid& grid,
                           const Eigen::Vector3d& target);

/// The nearest point in the neighbourhood of a start, or at least a nearer one.
/// @return  `converged` says whether no step within the box leads nearer
struct SurfaceDescent {
  SurfacePoint found;
  bool converged = false;
};
SurfaceDescent descend(const Geom_Surface& surface, const DomainBox& box, const Eigen::Vector2d& start,
                       const Eigen::Vector3d& target);

/// The parameter in [first, last] of the nearest point of a curve.
double nearest_parameter(const Geom_Curve& curve, double first, double last, const Eigen::Vector3d& target);

}  // namespace isopatch::geometry
