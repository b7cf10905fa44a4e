#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/brep/redrawn.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// Where one point of the drawing lies at different heights, since walls beside it are inclined.
struct VertexTrack {
  std::vector<std::pair<double, Eigen::Vector2d>> at;  ///< by height, m
};

/// Edges of the solid at different heights that are one edge of the drawing: inclined walls lie between them.
struct EdgeTrack {
  struct At {
    double height;  ///< m
    EdgeId edge;
    bool reversed;  ///< runs against the first
  };
  std::vector<At> at;  ///< by height
  /// As it is drawn: a line between these ends, else as the first edge.
  std::optional<std::array<Eigen::Vector2d, 2>> line = {};
};

/// A circle of the drawing that has other radii at other heights: cones about the direction, all around.
struct RingTrack {
  Eigen::Vector2d centre;
  std::vector<std::pair<double, double>> at;  ///< height and radius, by height, m; it is drawn with the first
};

/// What does not stay in its place from floor to floor. A drawing has what is inclined where it is lowest.
struct Tracks {
  std::vector<VertexTrack> vertices;
  std::vector<EdgeTrack> edges;
  std::vector<RingTrack> rings;
  geometry::Redrawn redrawn;  ///< edges of floors that are not drawn where they are
};

/// Nothing for a solid whose walls are all upright.
/// @throws Error unsupported  an inclined wall that is no strip between two edges across the direction,
/// naming it
Tracks tracks(const geometry::Brep& solid, const SweepFrame& frame);

/// The radius of a ring at a height over the one that it is drawn with.
double growth(const RingTrack& track, double height);

/// Where a vertex is at a height: linear between the heights at which it is known, constant beyond them.
Eigen::Vector2d place(const VertexTrack& track, double height);

}  // namespace isopatch::segmentation
