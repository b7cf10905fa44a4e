#pragma once

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The point of a surface nearest to a point of space.
struct SurfaceFoot {
  Parameter<2> parameter = Parameter<2>::Zero();
  double distance = 0;  ///< model units
};

/// Gauss-Newton from a start, with the parameters kept in the domain: the nearest point if the start is near
/// it.
/// @param start  in the domain
SurfaceFoot surface_foot(const NurbsSurface& surface, const Eigen::Vector3d& point, Parameter<2> start);

/// The same from the nearest points of a grid with degree + 1 points per element and direction.
/// @param enough  model units; the search ends once a point this close is found
SurfaceFoot surface_foot(const NurbsSurface& surface, const Eigen::Vector3d& point, double enough);

/// The parameter that the surface would have at the point if it went on beyond its edges along its tangents
/// there; that of the foot for points on the surface.
Parameter<2> continued_parameter(const NurbsSurface& surface, const Eigen::Vector3d& point,
                                 const SurfaceFoot& foot);

}  // namespace isopatch::geometry
