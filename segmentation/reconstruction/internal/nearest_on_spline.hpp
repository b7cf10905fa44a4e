#pragma once

#include <Eigen/Core>

#include "geometry/splines/nurbs.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"

namespace isopatch::segmentation {

/// Distances from a spline surface: a grid of its points finds where to begin, Gauss-Newton steps find the
/// nearest point of its domain.
class NearestOnSpline {
 public:
  explicit NearestOnSpline(geometry::NurbsSurface surface);
  Eigen::Vector2d parameters(const Eigen::Vector3d& point) const;
  /// From a start near it.
  Eigen::Vector2d parameters(const Eigen::Vector3d& point, const Eigen::Vector2d& start) const;
  /// With the sign that S_u x S_v has; derivatives by radii are 0.
  CarrierDistance distance(const Eigen::Vector3d& point) const;
  const geometry::NurbsSurface& surface() const { return surface_; }

 private:
  geometry::NurbsSurface surface_;
  Eigen::Matrix2Xd places_;
  Eigen::Matrix3Xd points_;
};

}  // namespace isopatch::segmentation
