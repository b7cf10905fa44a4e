#include "segmentation/sweeps/internal/drawing_at_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "segmentation/sweeps/internal/layers.hpp"
#include "segmentation/sweeps/internal/moving_drawing.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// Of each edge of a profile: lines have one piece; others are no longer than a quarter of a circle.
constexpr int most_pieces = 4;
int pieces_of(const ProfileEdge& edge) {
  return edge.points.size() == 2 ? 1 : most_pieces;
}

/// The edges of a profile in their pieces, one after the other.
Quadrangulation outlines_of(const Profile& profile) {
  Quadrangulation result;
  result.vertices = profile.vertices;
  const auto enter = [&](const Eigen::Vector2d& point) {
    result.vertices.push_back(point);
    return static_cast<int>(result.vertices.size()) - 1;
  };
  for (std::size_t e = 0; e < profile.edges.size(); ++e) {
    const ProfileEdge& edge = profile.edges[e];
    const int pieces = pieces_of(edge);
    const int first = edge.start < 0 ? enter(edge.points.front()) : edge.start;
    for (int i = 0, from = first; i < pieces; ++i) {
      const double low = static_cast<double>(i) / pieces, high = static_cast<double>(i + 1) / pieces;
      const int to = i + 1 < pieces ? enter(edge.points.front()) : edge.start < 0 ? first : edge.end;
      result.edges.push_back({from, to, static_cast<int>(e), low, high});
      from = to;
    }
  }
  return result;
}

/// Where walls begin and end, floors lie, and half-way up; from low to high.
std::vector<double> heights_of(const SweptDrawing& drawing) {
  const auto [low, high] = range_of(drawing.tracks);
  std::set<double> result = {low, (low + high) / 2, high};
  for (const std::vector<Slab>& slabs : drawing.slabs)
    for (const Slab& slab : slabs) result.insert({slab.low, slab.high});
  return {result.begin(), result.end()};
}

/// The quadrilaterals of a divided drawing at a height, where inclined walls have moved it.
Quadrangulation moved_to(const MovingDrawing& moving, const SweepFrame& frame, Quadrangulation quads,
                         double height) {
  for (std::size_t v = 0; v < quads.vertices.size(); ++v)
    quads.vertices[v] = frame.flat(moving.place(static_cast<int>(v), height));
  return quads;
}

Profile profile_of(const MovingDrawing& outlines, const SweepFrame& frame, const SweptDrawing& drawing,
                   double height) {
  Profile result = drawing.profile;
  for (std::size_t v = 0; v < result.vertices.size(); ++v)
    result.vertices[v] = frame.flat(outlines.place(static_cast<int>(v), height));
  int first = 0;  // piece of the edge
  for (ProfileEdge& edge : result.edges) {
    const int pieces = pieces_of(edge);
    const std::size_t last = edge.points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const double at = pieces * static_cast<double>(i) / static_cast<double>(last);
      const int piece = std::min(static_cast<int>(at), pieces - 1);
      edge.points[i] = outlines.outline_place(first + piece, at - piece, height);
    }
    first += pieces;
    edge.points.front() =
        edge.start < 0 ? edge.points.back() : result.vertices[static_cast<std::size_t>(edge.start)];
    if (edge.start >= 0) edge.points.back() = result.vertices[static_cast<std::size_t>(edge.end)];
  }
  return result;
}

}  // namespace

std::array<double, 2> range_of(const Tracks& tracks) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto enter = [&](double height) {
    low = std::min(low, height);
    high = std::max(high, height);
  };
  for (const VertexTrack& track : tracks.vertices)
    for (const auto& at : track.at) enter(at.first);
  for (const EdgeTrack& track : tracks.edges)
    for (const EdgeTrack::At& at : track.at) enter(at.height);
  for (const RingTrack& track : tracks.rings)
    for (const auto& at : track.at) enter(at.first);
  return {low, high};
}

Profile profile_at(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing, double height) {
  const Quadrangulation outlines = outlines_of(drawing.profile);
  return profile_of(MovingDrawing(solid, frame, drawing, outlines), frame, drawing, height);
}

ProfilesAtHeights profiles_at_heights(const Brep& solid, const SweepFrame& frame,
                                      const SweptDrawing& drawing) {
  const Quadrangulation outlines = outlines_of(drawing.profile);
  const MovingDrawing moving(solid, frame, drawing, outlines);
  ProfilesAtHeights result;
  for (const double height : heights_of(drawing)) {
    if (!result.heights.empty() && height - result.heights.back() < 1e-6 * solid.size()) continue;
    result.heights.push_back(height);
    result.profiles.push_back(profile_of(moving, frame, drawing, height));
  }
  return result;
}

Quadrangulation as_drawn(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                         const Quadrangulation& at_height, double height) {
  std::set<int> outlined;
  for (const QuadEdge& edge : at_height.edges)
    if (edge.profile_edge >= 0) outlined.insert({edge.start, edge.end});
  // How far vertices inside move follows from the outlines alone.
  const MovingDrawing moving(solid, frame, drawing, at_height);
  Quadrangulation result = at_height;
  for (std::size_t v = drawing.profile.vertices.size(); v < result.vertices.size(); ++v)
    if (!outlined.contains(static_cast<int>(v)))
      result.vertices[v] = moving.drawn_place(static_cast<int>(v), height);
  std::copy(drawing.profile.vertices.begin(), drawing.profile.vertices.end(), result.vertices.begin());
  return result;
}

StandingQuads standing_quads(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                             const ProfilesAtHeights& there, const Quadrangulation& quads) {
  const MovingDrawing moving(solid, frame, drawing, quads);
  StandingQuads result;
  result.upright.assign(quads.vertices.size(), 1);
  std::vector<double> most_slender(quads.quads.size(), 1);
  for (int v = 0; v < static_cast<int>(quads.vertices.size()); ++v)
    for (std::size_t h = 0; h + 1 < there.heights.size(); ++h) {
      const Eigen::Vector3d way = moving.place(v, there.heights[h + 1]) - moving.place(v, there.heights[h]);
      double& upright = result.upright[static_cast<std::size_t>(v)];
      upright = std::min(upright, way.dot(frame.along) / way.norm());
    }
  for (std::size_t h = 0; h < there.heights.size(); ++h) {
    const Quadrangulation moved = moved_to(moving, frame, quads, there.heights[h]);
    for (int q = 0; q < static_cast<int>(quads.quads.size()); ++q) {
      double steepest = 1;
      for (const geometry::EdgeUse& use : quads.quads[static_cast<std::size_t>(q)].sides) {
        const QuadEdge& edge = quads.edges[static_cast<std::size_t>(use.edge.value)];
        for (const int end : {edge.start, edge.end})
          steepest = std::min(steepest, result.upright[static_cast<std::size_t>(end)]);
      }
      const QuadShape shape = shape_of(there.profiles[h], moved, q);
      result.least_jacobian = std::min(result.least_jacobian, steepest * shape.jacobian);
      double& slenderness = most_slender[static_cast<std::size_t>(q)];
      slenderness = std::max(slenderness, shape.slenderness);
    }
  }
  const auto columns = layers(quads, drawing.slabs, moving, {}, 1e-7 * solid.size()).columns;
  for (std::size_t q = 0; q < columns.size(); ++q) {
    const auto count = static_cast<int>(columns[q].size());
    result.hexahedra += count;
    result.slenderness += count * std::pow(std::log(most_slender[q]), 2);
  }
  return result;
}

}  // namespace isopatch::segmentation
