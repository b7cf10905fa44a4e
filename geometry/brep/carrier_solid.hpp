#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/ids.hpp"
#include "geometry/brep/brep_parts.hpp"
#include "geometry/splines/nurbs.hpp"
#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

/// A solid by what its faces lie on and how they meet: the plain data that `make_brep` makes a solid of.
///
/// Faces that go around an axis have a seam: an edge that one of their loops walks in both directions. A pole
/// (of a sphere, the apex of a cone) is an edge without length.
struct CarrierSolid {
  /// Points on an edge, and more of them between.
  static constexpr int points_of_edge = 33;

  struct Edge {
    VertexId start, end;
    /// (3, n) from start to end along the edge, m, n = k * 32 + 1. What is a line, circle or ellipse through
    /// all within the tolerance becomes one; other edges are splines through them. Empty: a pole.
    Eigen::Matrix3Xd points;
    std::optional<NurbsCurve> curve;  ///< through the points, m, where it is known
  };
  struct Face {
    std::string name;
    Carrier carrier;                          ///< not looked at where there is a spline
    bool reversed = false;                    ///< whether the outward normal is against the surface's
    std::vector<std::vector<EdgeUse>> loops;  ///< walked with the face to the left, seen from outside
    std::optional<NurbsSurface> spline =
        {};  ///< freeform, m; no closed one: its loops are closed in its domain
  };
  Eigen::Matrix3Xd vertices;  ///< m
  std::vector<Edge> edges;
  std::vector<Face> faces;
};

}  // namespace isopatch::geometry
