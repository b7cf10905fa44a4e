#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "geometry/base/angle.hpp"
#include "geometry/topology/edge_use.hpp"
#include "segmentation/profiles/profile.hpp"

namespace isopatch::segmentation {

/// A side of quadrilaterals: a piece of a profile's edge, run in that edge's direction, or a straight chord,
/// or a parabola.
struct QuadEdge {
  int start = -1, end = -1;  ///< vertices of the quadrangulation
  int profile_edge = -1;     ///< -1: a chord
  double low = 0, high = 1;  ///< of the profile's edge's parameter; above 1 where the piece of a closed edge
                             ///< runs over its end
  std::optional<Eigen::Vector2d> apex = {};  ///< of a parabola: where the tangents at its ends meet
};

struct Quad {
  int region = -1;                         ///< of the profile
  std::array<geometry::EdgeUse, 4> sides;  ///< counterclockwise, of the quadrangulation's edges
};

/// Curved quadrilaterals that meet side to side and cover the wanted regions of a profile.
struct Quadrangulation {
  std::vector<Eigen::Vector2d> vertices;  ///< the profile's first, in its order
  std::vector<QuadEdge> edges;            ///< each is a side of one or two quadrilaterals
  std::vector<Quad> quads;
};

/// How far the corners of a quadrilateral are from right angles, and its sides' transfinite (Coons) map from
/// folding.
struct QuadShape {
  Angle smallest, largest;  ///< corner, between tangents of the sides
  double jacobian =
      0;  ///< the least of det / (length times length of the derivatives), on 7 x 7 points; 1: a rectangle
  double slenderness = 1;  ///< opposite sides' mean length over their least distance, at 7 points
};

/// @cost some microseconds a quadrilateral
QuadShape shape_of(const Profile& profile, const Quadrangulation& quads, int quad);

}  // namespace isopatch::segmentation
