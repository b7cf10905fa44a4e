#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/angle.hpp"
#include "geometry/base/ids.hpp"
#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

enum class SurfaceKind { plane, cylinder, cone, sphere, torus, spline, other };
enum class CurveKind { line, circle, ellipse, spline, other };

/// "plane", "cylinder", ...
const char* name(SurfaceKind kind);
const char* name(CurveKind kind);

/// Red, green and blue, each in [0, 1].
using Colour = std::array<double, 3>;

/// "#rrggbb", each channel rounded to a byte.
std::string hex_text(const Colour& colour);

/// A trimmed surface.
struct BrepFace {
  std::string name;              ///< the file's; "" where it has none
  std::optional<Colour> colour;  ///< the file's
  SurfaceKind kind = SurfaceKind::other;
  /// Whether the outward normal is opposite to S_u x S_v. Loops then run clockwise around the face in its
  /// domain.
  bool reversed = false;
  /// Closed; the outer loop first. On a periodic face (a whole cylinder) the first is the longest.
  std::vector<std::vector<EdgeUse>> loops;
};

/// A curve between two vertices, which are one on a closed edge.
struct BrepEdge {
  VertexId start, end;
  CurveKind kind = CurveKind::other;
  double length = 0;        ///< m
  double length_error = 0;  ///< m, estimate of its quadrature
  /// One for each use: two on a closed manifold, the same one twice for a seam.
  std::vector<FaceId> faces;
};

/// What a plane, cylinder, cone, sphere or torus is, in space.
struct Carrier {
  SurfaceKind kind = SurfaceKind::other;
  Eigen::Vector3d origin;    ///< on the axis, m: a point of the plane, the centre of a sphere or torus
  Eigen::Vector3d axis;      ///< unit; normal of a plane
  double radius = 0;         ///< m; of a cone at its origin; large one of a torus
  double second_radius = 0;  ///< m; small one of a torus
  Angle half_angle = {};     ///< of a cone, the radius grows along the axis by its tangent
};

/// A rectangle of surface parameters: u in [low(0), high(0)], v in [low(1), high(1)].
struct DomainBox {
  Eigen::Vector2d low, high;
};

/// A nearest point.
struct FaceProjection {
  Eigen::Vector2d uv;
  Eigen::Vector3d point;  ///< m
  double distance = 0;    ///< m
};
struct EdgeProjection {
  double t = 0;  ///< in [0, 1]
  Eigen::Vector3d point;
  double distance = 0;
};

}  // namespace isopatch::geometry
