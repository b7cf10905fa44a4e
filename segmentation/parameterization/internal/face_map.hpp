#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "segmentation/parameterization/face_map_kind.hpp"
#include "segmentation/parameterization/internal/arc_length.hpp"
#include "segmentation/parameterization/internal/hexahedron.hpp"

namespace isopatch::segmentation {

/// From shares of a side to its curve's parameter, [0, 1] to [0, 1], increasing; empty for shares of arc
/// length.
using SidePace = std::function<double(double)>;

/// The unit square mapped into a face's domain and on to its surface; sides are run through by arc length,
/// or at paces of their own.
class FaceMap {
 public:
  /// The blend of the sides.
  explicit FaceMap(QuadFace face);
  /// @param paces  in the order of `QuadFace::sides`
  FaceMap(QuadFace face, std::array<SidePace, 4> paces);

  const QuadFace& face() const { return face_; }
  FaceMapKind kind() const { return kind_; }
  /// How far a side turns on its way, in the order of `QuadFace::sides`; rad.
  double side_turning(int side) const { return arcs_[static_cast<std::size_t>(side)].turning(); }

  /// Extent of the outline in the domain.
  double domain_size() const { return domain_size_; }
  /// Parameter of a side's curve at a share.
  double side_parameter(int side, double share) const;
  /// The share that has a parameter: the inverse.
  double side_share(int side, double t) const;
  /// Points of a side at shares, (2, n) in the domain and (3, n) in space.
  Eigen::Matrix2Xd side_domain(int side, const std::vector<double>& shares) const;
  Eigen::Matrix3Xd on_surface(const Eigen::Matrix2Xd& domain) const;
  Eigen::Matrix3Xd side_points(int side, const std::vector<double>& shares) const;
  Eigen::Vector2d domain_point(double s, double t) const;
  Eigen::Vector3d point(double s, double t) const { return face_.surface(domain_point(s, t)); }
  /// On a grid, s running fastest; (2, n) and (3, n).
  Eigen::Matrix2Xd domain_grid(const std::vector<double>& s, const std::vector<double>& t) const;
  Eigen::Matrix3Xd grid(const std::vector<double>& s, const std::vector<double>& t) const;

  /// The same map with its inside moved by a spline displacement of the domain, whose outer control points
  /// are zero.
  /// @param kind  what that makes of it
  FaceMap moved(const geometry::NurbsSurface& displacement, FaceMapKind kind) const;

 private:
  QuadFace face_;
  std::array<SidePace, 4> paces_;
  std::vector<ArcLength> arcs_;
  std::vector<geometry::NurbsSurface> displacements_;  ///< third coordinate not used
  FaceMapKind kind_ = FaceMapKind::coons;
  double domain_size_ = 0;
};

/// The smallest sine of an angle between a face map's grid lines, on a grid of 24 x 24 cells; negative where
/// the map folds over in the domain. If it is positive, the piecewise linear map through the grid is
/// bijective onto the outline's polygon.
double smallest_sine(const FaceMap& map);

}  // namespace isopatch::segmentation
