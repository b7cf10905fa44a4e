#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/tessellation.hpp"
#include "segmentation/parameterization/internal/domain_curve.hpp"

namespace isopatch::segmentation {

/// A point of a face's outline.
struct OutlinePoint {
  int side = 0;  ///< in the order of `QuadFace::sides`
  double t = 0;  ///< of that side's curve
};

/// Triangles that fill the trimmed domain of a face.
struct DomainMesh {
  std::vector<Eigen::Vector2d> points;
  /// What the first points are: all around, as sides 0, 3, 1 and 2 have it, from the corner (0, 0). A corner
  /// belongs to the side that starts there.
  std::vector<OutlinePoint> outline;
  std::vector<std::array<int, 3>> triangles;  ///< turned as the outline is
};

/// The points of a side in the triangulation of its solid.
struct SidePoints {
  Eigen::VectorXd t;        ///< of the side's curve, increasing from 0 to 1
  Eigen::Matrix3Xd points;  ///< as the face's triangles have them, bit for bit
};

/// The triangulation that a CAD library gives of a face, with its outline in order.
/// @return  nothing where it does not fill the domain once, between its four sides
std::optional<DomainMesh> domain_mesh(const geometry::FaceTriangles& triangles,
                                      const std::array<SidePoints, 4>& side_points,
                                      const std::array<DomainCurve, 4>& sides);

}  // namespace isopatch::segmentation
