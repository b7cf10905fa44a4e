#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/brep/brep_parts.hpp"

namespace isopatch::segmentation {

/// Points of a part of a surface, and the planes of its triangles.
struct SurfaceSample {
  Eigen::Matrix3Xd points;   ///< vertices, m
  Eigen::Matrix3Xd middles;  ///< of plane facets
  Eigen::Matrix3Xd normals;  ///< of these, unit
};

struct CarrierFit {
  geometry::Carrier carrier;
  double largest = 0;  ///< distance of a point, m
};

/// A carrier of one kind by least squares of the distances; where to begin, the facets' normals say.
///
/// @param near  m; where points stay farther from it than this, it is given up early; 0: never
/// @return nothing where the facets say nothing or the points do not determine it
/// @cost  O(points), some ten steps
std::optional<CarrierFit> fit_carrier(geometry::SurfaceKind kind, const SurfaceSample& sample,
                                      double near = 0);

/// A torus through points, from the axis of a carrier of revolution that has some of them.
std::optional<CarrierFit> fit_torus(const geometry::Carrier& about, const Eigen::Matrix3Xd& points);

/// What of a carrier may change.
struct FitFreedom {
  bool turn = true;    ///< its axis' direction
  bool shift = true;   ///< its axis' place
  bool radius = true;  ///< radii and angle
};

/// The same, from a carrier near it.
std::optional<CarrierFit> refit_carrier(const geometry::Carrier& start, const Eigen::Matrix3Xd& points,
                                        const FitFreedom& free = {});

}  // namespace isopatch::segmentation
