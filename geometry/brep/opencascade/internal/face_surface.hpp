#pragma once

#include <Eigen/Core>
#include <Geom_Surface.hxx>
#include <memory>
#include <optional>

#include "geometry/brep/brep_parts.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A face's surface, and from points to its domain. In units of the kernel.
class FaceSurface {
 public:
  virtual ~FaceSurface() = default;
  FaceSurface() = default;
  FaceSurface(const FaceSurface&) = delete;
  FaceSurface& operator=(const FaceSurface&) = delete;
  virtual Handle(Geom_Surface) surface() const = 0;
  /// 0: not periodic.
  virtual double u_period() const { return 0; }
  virtual double v_period() const { return 0; }
  /// @param before  the parameters of a point nearby, which the result follows across seams and poles; none
  /// is known of the first point
  virtual Eigen::Vector2d parameters(const Eigen::Vector3d& point,
                                     const std::optional<Eigen::Vector2d>& before) const = 0;
};

/// @param start  a point of the seam, m, where the turn begins; on the axis: anywhere
/// @param scale  kernel units in a metre
std::unique_ptr<FaceSurface> carrier_surface(const Carrier& carrier, const Eigen::Vector3d& start,
                                             double scale);
/// Freeform; parameters are those of the nearest point in its domain.
std::unique_ptr<FaceSurface> spline_surface(const NurbsSurface& spline, double scale);

}  // namespace isopatch::geometry
