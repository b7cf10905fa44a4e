#include "segmentation/sweeps/internal/moving_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/internal/piece_of_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::NurbsCurve;

/// Pushed along the sweep to a height.
NurbsCurve at_height(const NurbsCurve& curve, const SweepFrame& frame, double height) {
  const double by = height - frame.height(curve.control_points().col(0));
  return NurbsCurve(curve.knots(), curve.control_points().colwise() + by * frame.along, curve.weights());
}

/// The straight blend of two curves of one kind.
NurbsCurve blend(const NurbsCurve& a, const NurbsCurve& b, double share) {
  if (a.knots() != b.knots() || (a.weights() - b.weights()).cwiseAbs().maxCoeff() > 1e-9)
    throw Error(ErrorCode::unsupported, "the edges of an inclined wall are of different kinds");
  return NurbsCurve(a.knots(), (1 - share) * a.control_points() + share * b.control_points(), a.weights());
}

}  // namespace

MovingDrawing::MovingDrawing(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                             const Quadrangulation& quads)
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
    places_[static_cast<std::size_t>(drawn.start)] = frame.flat(curves_[e].point(curves_[e].low()));
    places_[static_cast<std::size_t>(drawn.end)] = frame.flat(curves_[e].point(curves_[e].high()));
    for (const EdgeTrack& track : drawing.tracks.edges)
      if (!pieces_[e]) pieces_[e] = piece_on(track, static_cast<int>(e));
  }
  find_vertex_tracks();
}

/// Vertices where a track of vertices is drawn, then those that divide an edge that moves.
void MovingDrawing::find_vertex_tracks() {
  for (int v = 0; v < static_cast<int>(places_.size()); ++v)
    for (const VertexTrack& track : drawing_.tracks.vertices)
      if ((track.at.front().second - places_[static_cast<std::size_t>(v)]).norm() < 1e-6 * solid_.size())
        vertex_tracks_[v] = &track;
  for (std::size_t e = 0; e < pieces_.size(); ++e) {
    if (!pieces_[e]) continue;
    on_track_.try_emplace(quads_.edges[e].start, pieces_[e]->track, pieces_[e]->low);
    on_track_.try_emplace(quads_.edges[e].end, pieces_[e]->track, pieces_[e]->high);
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
    const Eigen::Vector2d along = (*track.line)[1] - (*track.line)[0], p = frame_.flat(point) - (*track.line)[0];
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

Eigen::Vector3d MovingDrawing::place(int vertex, double height) const {
  if (const auto known = vertex_tracks_.find(vertex); known != vertex_tracks_.end())
    return frame_.point(segmentation::place(*known->second, height), height);
  if (const auto known = on_track_.find(vertex); known != on_track_.end())
    return frame_.point(track_place(*known->second.first, known->second.second, height), height);
  return frame_.point(places_[static_cast<std::size_t>(vertex)], height);
}

NurbsCurve MovingDrawing::member_curve(const EdgeTrack::At& at, const Piece& piece, double height) const {
  double low = at.reversed ? 1 - piece.low : piece.low, high = at.reversed ? 1 - piece.high : piece.high;
  const bool turned = low > high;
  if (turned) std::swap(low, high);
  const double shift = low < -1e-12 || low >= 1 ? -std::floor(low) : 0;
  NurbsCurve curve = piece_of_curve(solid_, at.edge, std::max(0.0, low + shift), high + shift);
  return at_height(turned ? reversed(curve, 0) : curve, frame_, height);
}

NurbsCurve MovingDrawing::curve(int number, double height) const {
  const QuadEdge& drawn = edge(number);
  const auto& piece = pieces_[static_cast<std::size_t>(number)];
  if (piece && !piece->track->line) {
    const Between found = between(*piece->track, height);
    const NurbsCurve below = member_curve(*found.below, *piece, height);
    return found.share == 0 ? below : blend(below, member_curve(*found.above, *piece, height), found.share);
  }
  const NurbsCurve& still = curves_[static_cast<std::size_t>(number)];
  if (drawn.profile_edge < 0 || (still.degree(0) == 1 && still.size() == 2))
    return geometry::segment(place(drawn.start, height), place(drawn.end, height));
  return at_height(still, frame_, height);
}

bool MovingDrawing::moves(int number) const {
  const QuadEdge& drawn = edge(number);
  for (const int vertex : {drawn.start, drawn.end})
    if (vertex_tracks_.contains(vertex) || on_track_.contains(vertex)) return true;
  return pieces_[static_cast<std::size_t>(number)].has_value();
}

std::vector<double> MovingDrawing::kinks(int number) const {
  std::vector<double> result;
  const QuadEdge& drawn = edge(number);
  for (const int vertex : {drawn.start, drawn.end}) {
    if (const auto known = vertex_tracks_.find(vertex); known != vertex_tracks_.end())
      for (const auto& at : known->second->at) result.push_back(at.first);
    if (const auto known = on_track_.find(vertex); known != on_track_.end())
      for (const auto& at : known->second.first->at) result.push_back(at.height);
  }
  return result;
}

}  // namespace isopatch::segmentation
