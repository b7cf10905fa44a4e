#pragma once

#include <Eigen/Geometry>

#include "geometry/base/progress.hpp"
#include "geometry/patch_face.hpp"

namespace isopatch::geometry {

/// Box of the control points, which contains the patch; model units.
Eigen::AlignedBox3d box(const NurbsVolume& volume);

/// Volume by Gauss's theorem and Gauss quadrature on the six sides, exact for B-splines; model units^3.
/// Rational patches get 2 p + 8 points per element and direction, which integrates quarter arcs of degree 2
/// to round-off.
double volume(const NurbsVolume& patch);

/// Volume and its moments, model units^3, ^4 and ^5.
struct VolumeMoments {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< integral of x - origin
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< integral of (x - origin) (x - origin)^T
};
/// The same way as `volume`, with as many more points as the higher powers ask for.
/// @param origin  about which moments are taken; near the patch, so that nothing cancels
VolumeMoments volume_moments(const NurbsVolume& patch, const Eigen::Vector3d& origin);

/// Area by Gauss quadrature with as many points as the volume; model units^2.
double area(const NurbsSurface& surface);

/// Outward unit normal of a patch's side at a face parameter, for a right-handed patch.
Eigen::Vector3d outward_normal(const NurbsVolume& patch, Side side, const Parameter<2>& face_parameter);

/// det J divided by the product of the columns' lengths at the Gauss points: 1 for a brick, <= 0 for a fold.
struct Quality {
  double min_scaled_jacobian = 1;
  double mean_scaled_jacobian = 1;
  double min_jacobian = 0;       ///< smallest det J at a Gauss point, model units^3 per parameter^3
  Parameter<3> worst_parameter;  ///< of min_jacobian
};
/// @param points_per_direction  Gauss points per element and direction; 0: degree + 1
/// @param progress  hears of the share of the points
Quality quality(const NurbsVolume& patch, int points_per_direction = 0, const Progress& progress = {});

}  // namespace isopatch::geometry
