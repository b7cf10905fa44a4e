#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A plane as a user gives it, by one of these.
struct GivenPlane {
  std::optional<Eigen::Vector3d> normal;  ///< of any length
  std::optional<Eigen::Vector3d> point;   ///< with `normal`, m; nothing: the middle of the solid's box
  std::string face;                       ///< a plane face, which is extended, by its name or as "face 3"
  std::vector<Eigen::Vector3d> through;   ///< three points or more of one plane, m
  bool operator==(const GivenPlane&) const = default;
};

/// @throws Error invalid_argument  none or several of its ways, a normal without length
void validate(const GivenPlane& plane);

/// @throws Error invalid_argument  no face of that name, or one that is not plane; points that are on a line,
/// or farther than 1e-6 of the solid's size from one plane
geometry::PlaneSurface plane_of(const geometry::Brep& solid, const GivenPlane& given);

}  // namespace isopatch::segmentation
