#include "segmentation/sweeps/internal/moving_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/internal/offset_curve.hpp"
#include "segmentation/sweeps/internal/straight_wall.hpp"
#include "segmentation/sweeps/piece_of_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::NurbsCurve;

/// Pushed along the sweep to a height.
NurbsCurve pushed(const NurbsCurve& curve, const SweepFrame& frame, double height) {
  const double by = height - frame.height(curve.control_points().col(0));
  return NurbsCurve(curve.knots(), curve.control_points().colwise() + by * frame.along, curve.weights());
}

/// The straight blend of two curves.
NurbsCurve blend(const NurbsCurve& a, const NurbsCurve& b, double share) {
  const geometry::NurbsSurface between = straight_wall(a, b);
  const Eigen::Index count = between.size(0);
  const Eigen::Matrix4Xd points = between.homogeneous();
  return NurbsCurve::from_homogeneous({between.knots(0)},
                                      (1 - share) * points.leftCols(count) + share * points.rightCols(count));
}

/// How far a height is from those of a track; 0 between its lowest and its highest.
double distance(double lowest, double highest, double height) {
  return std::max({0.0, lowest - height, height - highest});
}

}  // namespace

MovingDrawing::MovingDrawing(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                             const Quadrangulation& quads, const std::map<int, double>& offsets)
    : solid_(solid),
      frame_(frame),
      drawing_(drawing),
      quads_(quads),
      places_(quads.vertices),
      curves_(quads.edges.size()),
      pieces_(quads.edges.size()) {
  for (std::size_t e = 0; e < quads.edges.size(); ++e) {
    const QuadEdge& drawn = quads.edges[e];
    if (drawn.profile_edge < 0) continue;
    curves_[e] = piece_of_curve(drawing.sheet, EdgeId(drawn.profile_edge), drawn.low, drawn.high);
    const auto offset = offsets.find(static_cast<int>(e));
    if (offset != offsets.end()) {
      const auto beside = offset_curve(curves_[e], frame.along, offset->second);
      if (!beside) throw Error(ErrorCode::unsupported, "a round along an outline of no exact offset");
      curves_[e] = *beside;
      beside_.insert(static_cast<int>(e));
    }
    places_[static_cast<std::size_t>(drawn.start)] = frame.flat(curves_[e].point(curves_[e].low()));
    places_[static_cast<std::size_t>(drawn.end)] = frame.flat(curves_[e].point(curves_[e].high()));
    if (offset != offsets.end()) continue;
    for (const EdgeTrack& track : drawing.tracks.edges)
      if (const auto piece = piece_on(track, static_cast<int>(e))) pieces_[e].push_back(*piece);
  }
  find_vertex_tracks();
  find_rings();
  find_inner_vertices();
}

/// Vertices where a track of vertices is drawn, then those that divide an edge that moves.
void MovingDrawing::find_vertex_tracks() {
  for (int v = 0; v < static_cast<int>(places_.size()); ++v)
    for (const VertexTrack& track : drawing_.tracks.vertices)
      if ((track.at.front().second - places_[static_cast<std::size_t>(v)]).norm() < 1e-6 * solid_.size())
        vertex_tracks_[v].push_back(&track);
  for (std::size_t e = 0; e < pieces_.size(); ++e) {
    for (const Piece& piece : pieces_[e]) {
      on_track_[quads_.edges[e].start].push_back({piece.track, piece.low, piece.low});
      on_track_[quads_.edges[e].end].push_back({piece.track, piece.high, piece.high});
    }
  }
}

const MovingDrawing::Piece* MovingDrawing::at_height(const std::vector<Piece>& pieces, double height) {
  const auto off = [&](const Piece& piece) {
    return distance(piece.track->at.front().height, piece.track->at.back().height, height);
  };
  const auto nearest = std::min_element(pieces.begin(), pieces.end(),
                                        [&](const Piece& a, const Piece& b) { return off(a) < off(b); });
  return nearest == pieces.end() ? nullptr : &*nearest;
}

void MovingDrawing::find_rings() {
  for (std::size_t e = 0; e < quads_.edges.size(); ++e) {
    const QuadEdge& drawn = quads_.edges[e];
    if (drawn.profile_edge < 0 || beside_.contains(static_cast<int>(e))) continue;
    for (const RingTrack& ring : drawing_.tracks.rings) {
      const auto is_on = [&](double share) {
        const double radius = (frame_.flat(sheet_point(drawn, share)) - ring.centre).norm();
        return std::abs(radius - ring.at.front().second) < 1e-6 * solid_.size();
      };
      if (!is_on(0) || !is_on(0.5) || !is_on(1)) continue;
      edge_rings_[static_cast<int>(e)] = &ring;
      vertex_rings_[drawn.start] = vertex_rings_[drawn.end] = &ring;
    }
  }
}

Eigen::Vector3d MovingDrawing::sheet_point(const QuadEdge& drawn, double share) const {
  const double t = drawn.low + share * (drawn.high - drawn.low);
  return drawing_.sheet.point(EdgeId(drawn.profile_edge), t > 1 ? t - 1 : t);
}

/// Of a point in the plane of the drawing; NaN if it is not there.
double MovingDrawing::parameter_on(const EdgeTrack& track, const Eigen::Vector3d& point) const {
  const double tolerance = 1e-6 * solid_.size();
  if (track.line) {
    const Eigen::Vector2d along = (*track.line)[1] - (*track.line)[0],
                          p = frame_.flat(point) - (*track.line)[0];
    const double t = p.dot(along) / along.squaredNorm();
    const bool off = (p - t * along).norm() > tolerance || t * along.norm() < -tolerance ||
                     (t - 1) * along.norm() > tolerance;
    return off ? std::nan("") : t;
  }
  const EdgeTrack::At& first = track.at.front();
  const Eigen::Vector3d lifted = point + (first.height - frame_.height(point)) * frame_.along;
  const geometry::EdgeProjection nearest = solid_.project(first.edge, lifted);
  return nearest.distance > tolerance ? std::nan("") : nearest.t;
}

std::optional<MovingDrawing::Piece> MovingDrawing::piece_on(const EdgeTrack& track, int number) const {
  const QuadEdge& drawn = edge(number);
  const double middle = parameter_on(track, sheet_point(drawn, 0.5));
  double low = parameter_on(track, sheet_point(drawn, 0)), high = parameter_on(track, sheet_point(drawn, 1));
  if (!std::isfinite(low + middle + high)) return std::nullopt;
  const geometry::BrepEdge& first = solid_.edge(track.at.front().edge);
  if (first.start == first.end) {  // on a closed edge: less than half of it to either side of the middle
    low += std::round(middle - low);
    high += std::round(middle - high);
  }
  return Piece{&track, low, high};
}

MovingDrawing::Between MovingDrawing::between(const EdgeTrack& track, double height) {
  const auto above =
      std::find_if(track.at.begin(), track.at.end(), [&](const auto& at) { return at.height >= height; });
  if (above == track.at.begin()) return {&*above, &*above, 0};
  if (above == track.at.end()) return {&track.at.back(), &track.at.back(), 0};
  const auto below = std::prev(above);
  return {&*below, &*above, (height - below->height) / (above->height - below->height)};
}

Eigen::Vector2d MovingDrawing::track_place(const EdgeTrack& track, double t, double height) const {
  const double inside = t - std::floor(t);
  const double wrapped = t >= 0 && t <= 1 ? t : inside;
  const auto at = [&](const EdgeTrack::At& member) {
    return frame_.flat(solid_.point(member.edge, member.reversed ? 1 - wrapped : wrapped));
  };
  const Between found = between(track, height);
  return (1 - found.share) * at(*found.below) + found.share * at(*found.above);
}

std::optional<Eigen::Vector2d> MovingDrawing::tracked_place(int vertex, double height) const {
  for (const auto* rings : {&vertex_rings_, &discs_}) {
    const auto known = rings->find(vertex);
    if (known == rings->end()) continue;
    const Eigen::Vector2d centre = known->second->centre;
    return centre + growth(*known->second, height) * (places_[static_cast<std::size_t>(vertex)] - centre);
  }
  if (const auto known = vertex_tracks_.find(vertex); known != vertex_tracks_.end()) {
    const auto off = [&](const VertexTrack* track) {
      return distance(track->at.front().first, track->at.back().first, height);
    };
    const VertexTrack* nearest =
        *std::min_element(known->second.begin(), known->second.end(),
                          [&](const VertexTrack* a, const VertexTrack* b) { return off(a) < off(b); });
    return segmentation::place(*nearest, height);
  }
  if (const auto known = on_track_.find(vertex); known != on_track_.end()) {
    const Piece* piece = at_height(known->second, height);
    return track_place(*piece->track, piece->low, height);
  }
  return std::nullopt;
}

void MovingDrawing::find_inner_vertices() {
  std::vector<bool> outlined(places_.size(), false);
  std::fill_n(outlined.begin(), drawing_.profile.vertices.size(), true);
  for (const QuadEdge& drawn : quads_.edges)
    if (drawn.profile_edge >= 0)
      for (const int end : {drawn.start, drawn.end}) outlined[static_cast<std::size_t>(end)] = true;
  for (const QuadEdge& drawn : quads_.edges)
    for (const auto& [end, other] : {std::pair(drawn.start, drawn.end), std::pair(drawn.end, drawn.start)})
      if (!outlined[static_cast<std::size_t>(end)]) inner_[end].push_back(other);
  find_discs();
}

/// What has no outline around it but one ring grows with that.
void MovingDrawing::find_discs() {
  std::set<int> left;
  for (const auto& [vertex, neighbours] : inner_) left.insert(vertex);
  while (!left.empty()) {
    std::vector<int> together = {*left.begin()};
    left.erase(left.begin());
    std::set<const RingTrack*> around;
    for (std::size_t i = 0; i < together.size(); ++i)
      for (const int other : inner_.at(together[i])) {
        if (left.erase(other) > 0) together.push_back(other);
        if (inner_.contains(other)) continue;
        const auto ring = vertex_rings_.find(other);
        around.insert(ring == vertex_rings_.end() ? nullptr : ring->second);
      }
    if (around.size() != 1 || !*around.begin()) continue;
    for (const int vertex : together) discs_[vertex] = *around.begin();
  }
  for (const auto& [vertex, ring] : discs_) inner_.erase(vertex);
}

Eigen::Vector2d MovingDrawing::drawn_place(int vertex, double height) const {
  const Eigen::Vector2d& there = places_[static_cast<std::size_t>(vertex)];
  if (const auto disc = discs_.find(vertex); disc != discs_.end()) {
    const Eigen::Vector2d& centre = disc->second->centre;
    return centre + (there - centre) / growth(*disc->second, height);
  }
  return there - shifts(height)[static_cast<std::size_t>(vertex)];
}

const std::vector<Eigen::Vector2d>& MovingDrawing::shifts(double height) const {
  const auto [found, fresh] = shifts_.try_emplace(height);
  std::vector<Eigen::Vector2d>& result = found->second;
  if (!fresh) return result;
  result.assign(places_.size(), Eigen::Vector2d::Zero());
  for (int v = 0; v < static_cast<int>(places_.size()); ++v)
    if (const auto tracked = tracked_place(v, height))
      result[static_cast<std::size_t>(v)] = *tracked - places_[static_cast<std::size_t>(v)];
  constexpr int sweeps = 200;  // only the quality of blocks depends on how near they come to the mean
  for (int i = 0; i < sweeps; ++i)
    for (const auto& [vertex, neighbours] : inner_) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const int other : neighbours) sum += result[static_cast<std::size_t>(other)];
      result[static_cast<std::size_t>(vertex)] = sum / static_cast<double>(neighbours.size());
    }
  return result;
}

Eigen::Vector3d MovingDrawing::place(int vertex, double height) const {
  const auto v = static_cast<std::size_t>(vertex);
  const Tracks& tracks = drawing_.tracks;
  if (tracks.vertices.empty() && tracks.edges.empty() && tracks.rings.empty())
    return frame_.point(places_[v], height);
  return frame_.point(places_[v] + shifts(height)[v], height);
}

/// Moves by the mean of the ends.
Eigen::Vector3d MovingDrawing::apex(const QuadEdge& drawn, double height) const {
  const auto start = static_cast<std::size_t>(drawn.start), end = static_cast<std::size_t>(drawn.end);
  const Eigen::Vector3d moved = place(drawn.start, height) - frame_.point(places_[start], height) +
                                place(drawn.end, height) - frame_.point(places_[end], height);
  return frame_.point(*drawn.apex, height) + moved / 2;
}

NurbsCurve MovingDrawing::member_curve(const EdgeTrack::At& at, const Piece& piece, double height) const {
  double low = at.reversed ? 1 - piece.low : piece.low, high = at.reversed ? 1 - piece.high : piece.high;
  const bool turned = low > high;
  if (turned) std::swap(low, high);
  const double shift = low < -1e-12 || low >= 1 ? -std::floor(low) : 0;
  NurbsCurve curve = piece_of_curve(solid_, at.edge, std::max(0.0, low + shift), high + shift);
  return pushed(turned ? reversed(curve, 0) : curve, frame_, height);
}

NurbsCurve MovingDrawing::curve(int number, double height) const {
  const QuadEdge& drawn = edge(number);
  const Piece* piece = at_height(pieces_[static_cast<std::size_t>(number)], height);
  if (piece && !piece->track->line) {
    const Between found = between(*piece->track, height);
    const NurbsCurve below = member_curve(*found.below, *piece, height);
    return found.share == 0 ? below : blend(below, member_curve(*found.above, *piece, height), found.share);
  }
  const NurbsCurve& still = curves_[static_cast<std::size_t>(number)];
  if (const auto ring = edge_rings_.find(number); ring != edge_rings_.end()) {
    const Eigen::Vector3d centre = frame_.point(ring->second->centre, 0);
    const double factor = growth(*ring->second, height);
    const NurbsCurve scaled(still.knots(),
                            (factor * (still.control_points().colwise() - centre)).colwise() + centre,
                            still.weights());
    return pushed(scaled, frame_, height);
  }
  if (drawn.apex) {
    Eigen::Matrix3Xd points(3, 3);
    points << place(drawn.start, height), apex(drawn, height), place(drawn.end, height);
    return NurbsCurve({geometry::KnotVector(2, {0, 0, 0, 1, 1, 1})}, points);
  }
  if (drawn.profile_edge < 0 || is_segment(still))
    return geometry::segment(place(drawn.start, height), place(drawn.end, height));
  return pushed(still, frame_, height);
}

Eigen::Vector2d MovingDrawing::outline_place(int number, double share, double height) const {
  const QuadEdge& drawn = edge(number);
  const Piece* piece = at_height(pieces_[static_cast<std::size_t>(number)], height);
  if (piece && !piece->track->line)
    return track_place(*piece->track, piece->low + share * (piece->high - piece->low), height);
  Eigen::Vector2d still = frame_.flat(sheet_point(drawn, share));
  if (const auto ring = edge_rings_.find(number); ring != edge_rings_.end())
    return ring->second->centre + growth(*ring->second, height) * (still - ring->second->centre);
  if (!is_segment(curves_[static_cast<std::size_t>(number)])) return still;
  return frame_.flat((1 - share) * place(drawn.start, height) + share * place(drawn.end, height));
}

std::vector<double> MovingDrawing::kinks(int number) const {
  std::vector<double> result = kinks_at(edge(number).start);
  for (const double kink : kinks_at(edge(number).end)) result.push_back(kink);
  return result;
}

std::vector<double> MovingDrawing::kinks_at(int vertex) const {
  std::vector<double> result;
  if (const auto known = vertex_tracks_.find(vertex); known != vertex_tracks_.end())
    for (const VertexTrack* track : known->second)
      for (const auto& at : track->at) result.push_back(at.first);
  if (const auto known = vertex_rings_.find(vertex); known != vertex_rings_.end())
    for (const auto& at : known->second->at) result.push_back(at.first);
  if (const auto known = on_track_.find(vertex); known != on_track_.end())
    for (const Piece& piece : known->second)
      for (const auto& at : piece.track->at) result.push_back(at.height);
  return result;
}

}  // namespace isopatch::segmentation
