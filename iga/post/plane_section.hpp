#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// A plane, and how much of it cuts.
struct CuttingPlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d normal =
      Eigen::Vector3d::UnitX();  ///< length 1, from the part that is kept to the other one
  double radius = std::numeric_limits<double>::infinity();  ///< of the disc about the point that cuts, m
  bool operator==(const CuttingPlane&) const = default;
};

/// Points of quadrature on the cut of a part with a plane.
struct SectionPoint {
  int patch = 0;
  geometry::Parameter<3> parameter;
  Eigen::Vector3d place;  ///< in the plane, m
  double area = 0;        ///< weight, m^2
};

/// The cut of a part with a plane, as points of quadrature.
///
/// Every element is cut into tetrahedra in its parameters, of which the plane cuts triangles. Corners and
/// middles of edges of these lie in the plane, and on the faces of the part where its outline is: quadratic
/// triangles, so the error is of the fourth order in the pieces' size where the part is smooth.
///
/// @param patches  of the solution space
/// @return  nothing where the plane passes the part by
/// @cost   about 1,000 evaluations of geometry per element near the plane
std::vector<SectionPoint> section_points(const std::vector<geometry::NurbsVolume>& patches,
                                         const CuttingPlane& plane);

/// What the part on the side of the normal does to the other one across a cut.
struct SectionForces {
  double area = 0;                                   ///< m^2
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the area, m
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< integral of stress times normal, N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the plane's point, N m
};

/// Integrates the stresses of a field over a cut.
/// @param points  of the field's patches
SectionForces section_forces(const ElasticField& field, const CuttingPlane& plane,
                             const std::vector<SectionPoint>& points);

}  // namespace isopatch::iga
