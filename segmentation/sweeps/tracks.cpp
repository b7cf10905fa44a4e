#include "segmentation/sweeps/internal/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::EdgeUse;

/// Between values known at heights on straight lines, above and below as the nearest.
template <class Value>
Value at_height(const std::vector<std::pair<double, Value>>& known, double height) {
  const auto above =
      std::find_if(known.begin(), known.end(), [&](const auto& at) { return at.first >= height; });
  if (above == known.begin()) return above->second;
  if (above == known.end()) return known.back().second;
  const auto below = std::prev(above);
  const double share = (height - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

class Tracker {
 public:
  Tracker(const Brep& solid, const SweepFrame& frame)
      : solid_(solid),
        frame_(frame),
        tolerance_(1e-7 * solid.size()),
        vertex_sets_(static_cast<int>(solid.vertices().cols())) {
    for (std::size_t e = 0; e < solid.edges().size(); ++e)
      level_.push_back(level_of(EdgeId(static_cast<int>(e))));
  }

  Tracks make() {
    if (frame_.inclined.empty()) return {};
    find_rings();
    for (std::size_t e = 0; e < solid_.edges().size(); ++e)
      if (const geometry::BrepEdge& edge = solid_.edges()[e];
          !level_[e] && !on_rings_.contains(EdgeId(static_cast<int>(e))) && !is_of_floor(edge))
        vertex_sets_.unite(edge.start.value, edge.end.value);
    find_strips();
    collect_vertices();
    collect_edges();
    redraw();
    return std::move(result_);
  }

 private:
  struct Strip {
    EdgeId low, high;
    bool reversed;  // they run against each other
  };

  double height(const Eigen::Vector3d& point) const { return frame_.height(point); }

  /// The height of an edge across the direction; nothing for one that rises.
  std::optional<double> level_of(EdgeId edge) const {
    const double first = height(solid_.point(edge, 0));
    constexpr int samples = 8;
    for (int i = 1; i <= samples; ++i)
      if (std::abs(height(solid_.point(edge, static_cast<double>(i) / samples)) - first) > tolerance_)
        return std::nullopt;
    return first;
  }
  const std::optional<double>& level(EdgeId edge) const {
    return level_[static_cast<std::size_t>(edge.value)];
  }

  /// Of a roof, if it rises.
  bool is_of_floor(const geometry::BrepEdge& edge) const {
    return std::any_of(edge.faces.begin(), edge.faces.end(), [&](FaceId face) {
      return std::find(frame_.floors.begin(), frame_.floors.end(), face) != frame_.floors.end();
    });
  }

  /// A wall all around its axis, from one circle to another.
  struct Ring {
    FaceId face;
    Eigen::Vector2d centre;
    std::array<std::pair<double, double>, 2> ends;  // height and radius
  };

  std::optional<Ring> ring_of(FaceId face) const {
    const auto carrier = solid_.carrier(face);
    if (!carrier ||
        (carrier->kind != geometry::SurfaceKind::cone && carrier->kind != geometry::SurfaceKind::cylinder))
      return std::nullopt;
    const Eigen::Vector2d centre = frame_.flat(carrier->origin);
    std::map<double, double> lengths;  // of the level edges at each height
    std::map<double, double> radii;
    for (const auto& loop : solid_.face(face).loops)
      for (const EdgeUse& use : loop) {
        if (!level(use.edge)) continue;
        const auto known = std::find_if(lengths.begin(), lengths.end(), [&](const auto& at) {
          return std::abs(at.first - *level(use.edge)) < tolerance_;
        });
        const double height = known == lengths.end() ? *level(use.edge) : known->first;
        lengths[height] += solid_.edge(use.edge).length;
        radii[height] = (frame_.flat(solid_.point(use.edge, 0.3)) - centre).norm();
      }
    if (lengths.size() != 2) return std::nullopt;
    for (const auto& [height, length] : lengths)
      if (std::abs(length - 2 * std::numbers::pi * radii[height]) > 1e-6 * length) return std::nullopt;
    return Ring{face, centre, {*radii.begin(), *radii.rbegin()}};
  }

  /// Rings that go on in one another are one track, if cones are among them.
  void find_rings() {
    std::vector<Ring> rings;
    for (const FaceId face : frame_.walls)
      if (const auto ring = ring_of(face)) rings.push_back(*ring);
    UnionFind sets(static_cast<int>(rings.size()));
    const auto near = [&](double a, double b) { return std::abs(a - b) < tolerance_; };
    for (std::size_t i = 0; i < rings.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const auto& a : rings[i].ends)
          for (const auto& b : rings[j].ends)
            if (near(a.first, b.first) && near(a.second, b.second) &&
                (rings[i].centre - rings[j].centre).norm() < tolerance_)
              sets.unite(static_cast<int>(i), static_cast<int>(j));
    std::map<int, std::vector<const Ring*>> tracks;
    for (std::size_t i = 0; i < rings.size(); ++i)
      tracks[sets.find(static_cast<int>(i))].push_back(&rings[i]);
    for (const auto& [root, members] : tracks) add_ring_track(members);
  }

  void add_ring_track(const std::vector<const Ring*>& members) {
    RingTrack track{members.front()->centre, {}};
    for (const Ring* ring : members) track.at.insert(track.at.end(), ring->ends.begin(), ring->ends.end());
    std::sort(track.at.begin(), track.at.end());
    track.at.erase(std::unique(track.at.begin(), track.at.end(),
                               [&](const auto& a, const auto& b) { return b.first - a.first < tolerance_; }),
                   track.at.end());
    const double drawn = track.at.front().second;
    if (std::all_of(track.at.begin(), track.at.end(),
                    [&](const auto& at) { return std::abs(at.second - drawn) < tolerance_; }))
      return;
    for (const Ring* ring : members) {
      around_.insert(ring->face);
      for (const auto& loop : solid_.face(ring->face).loops)
        for (const EdgeUse& use : loop) {
          on_rings_.insert(use.edge);
          if (!level(use.edge)) continue;
          const double radius = (frame_.flat(solid_.point(use.edge, 0.3)) - track.centre).norm();
          if (std::abs(radius - drawn) > tolerance_)
            result_.redrawn[use.edge] = geometry::Scaled{frame_.point(track.centre, 0), drawn / radius};
        }
    }
    result_.rings.push_back(std::move(track));
  }

  std::optional<Strip> strip_of(FaceId face) const {
    const auto& loops = solid_.face(face).loops;
    if (loops.size() != 1) return std::nullopt;
    std::vector<EdgeUse> across;
    for (const EdgeUse& use : loops.front())
      if (level(use.edge)) across.push_back(use);
    if (across.size() != 2 || loops.front().size() != 4) return std::nullopt;
    if (*level(across[0].edge) > *level(across[1].edge)) std::swap(across[0], across[1]);
    if (*level(across[1].edge) - *level(across[0].edge) < tolerance_) return std::nullopt;
    return Strip{across[0].edge, across[1].edge, across[0].reversed == across[1].reversed};
  }

  void find_strips() {
    const std::set<FaceId> inclined(frame_.inclined.begin(), frame_.inclined.end());
    for (const FaceId face : frame_.walls) {
      if (around_.contains(face)) continue;
      if (const auto strip = strip_of(face))
        strips_.push_back(*strip);
      else if (inclined.contains(face))
        throw Error(ErrorCode::unsupported,
                    fmt::format("{} is inclined and not a strip between two edges across the direction",
                                describe(solid_, face)));
    }
  }

  Eigen::Vector2d flat(VertexId vertex) const { return frame_.flat(solid_.vertex(vertex)); }

  void collect_vertices() {
    std::map<int, std::vector<VertexId>> sets;
    for (int v = 0; v < static_cast<int>(solid_.vertices().cols()); ++v)
      sets[vertex_sets_.find(v)].emplace_back(v);
    for (auto& [root, members] : sets) {
      std::sort(members.begin(), members.end(),
                [&](VertexId a, VertexId b) { return height(solid_.vertex(a)) < height(solid_.vertex(b)); });
      drawn_at_[root] = flat(members.front());
      VertexTrack track;
      double moved = 0;
      for (const VertexId vertex : members) {
        const double at = height(solid_.vertex(vertex));
        if (!track.at.empty() && at - track.at.back().first < tolerance_) {
          if ((flat(vertex) - track.at.back().second).norm() > tolerance_)
            throw Error(ErrorCode::unsupported,
                        fmt::format("walls meet in a way that is no stack at {}", describe(solid_, vertex)));
          continue;
        }
        track.at.emplace_back(at, flat(vertex));
        moved = std::max(moved, (flat(vertex) - flat(members.front())).norm());
      }
      if (moved > tolerance_) result_.vertices.push_back(std::move(track));
    }
  }

  Eigen::Vector2d drawn_at(VertexId vertex) { return drawn_at_.at(vertex_sets_.find(vertex.value)); }

  /// Edges joined by strips, each with whether it runs against the first.
  std::vector<std::map<EdgeId, bool>> joined_edges() const {
    std::map<EdgeId, std::vector<std::pair<EdgeId, bool>>> beside;
    for (const Strip& strip : strips_) {
      beside[strip.low].emplace_back(strip.high, strip.reversed);
      beside[strip.high].emplace_back(strip.low, strip.reversed);
    }
    std::vector<std::map<EdgeId, bool>> result;
    for (std::size_t e = 0; e < level_.size(); ++e)
      if (const EdgeId edge(static_cast<int>(e)); level_[e] && !on_rings_.contains(edge)) beside[edge];
    std::set<EdgeId> done;
    for (const auto& [first, others] : beside) {
      if (done.contains(first)) continue;
      std::map<EdgeId, bool>& set = result.emplace_back();
      set[first] = false;
      std::vector<EdgeId> open = {first};
      while (!open.empty()) {
        const EdgeId edge = open.back();
        open.pop_back();
        done.insert(edge);
        for (const auto& [other, reversed] : beside.at(edge))
          if (set.try_emplace(other, set.at(edge) != reversed).second) open.push_back(other);
      }
    }
    return result;
  }

  /// Or is drawn elsewhere, since its ends move.
  bool moves(const EdgeTrack& track) {
    const geometry::BrepEdge& lowest = solid_.edge(track.at.front().edge);
    for (const VertexId end : {lowest.start, lowest.end})
      if ((drawn_at(end) - flat(end)).norm() > tolerance_) return true;
    for (const double t : {0.0, 0.31, 1.0})
      for (const EdgeTrack::At& at : track.at) {
        const Eigen::Vector2d first = frame_.flat(solid_.point(track.at.front().edge, t));
        if ((frame_.flat(solid_.point(at.edge, at.reversed ? 1 - t : t)) - first).norm() > tolerance_)
          return true;
      }
    return false;
  }

  void collect_edges() {
    for (const auto& set : joined_edges()) {
      EdgeTrack track;
      for (const auto& [edge, reversed] : set) track.at.push_back({*level(edge), edge, reversed});
      std::sort(track.at.begin(), track.at.end(),
                [](const EdgeTrack::At& a, const EdgeTrack::At& b) { return a.height < b.height; });
      if (track.at.front().reversed)
        for (EdgeTrack::At& at : track.at) at.reversed = !at.reversed;
      if (moves(track)) result_.edges.push_back(std::move(track));
    }
  }

  bool is_line(EdgeId edge) const { return solid_.edge(edge).kind == geometry::CurveKind::line; }

  std::array<Eigen::Vector2d, 2> drawn_ends(EdgeId edge) {
    return {drawn_at(solid_.edge(edge).start), drawn_at(solid_.edge(edge).end)};
  }

  std::array<Eigen::Vector3d, 2> line_between(const std::array<Eigen::Vector2d, 2>& ends) const {
    return {frame_.point(ends[0], 0), frame_.point(ends[1], 0)};
  }

  void redraw() {
    for (EdgeTrack& track : result_.edges) {
      const EdgeId lowest = track.at.front().edge;
      if (std::all_of(track.at.begin(), track.at.end(), [&](const auto& at) { return is_line(at.edge); }))
        track.line = drawn_ends(lowest);
      else if (const auto ends = drawn_ends(lowest);
               (ends[0] - flat(solid_.edge(lowest).start)).norm() > tolerance_ ||
               (ends[1] - flat(solid_.edge(lowest).end)).norm() > tolerance_)
        throw Error(ErrorCode::unsupported,
                    fmt::format("{} is curved and ends at inclined walls", describe(solid_, lowest)));
      for (const EdgeTrack::At& at : track.at) {
        if (track.line)
          result_.redrawn[at.edge] = line_between(drawn_ends(at.edge));
        else if (at.edge != lowest)
          result_.redrawn[at.edge] = EdgeUse{lowest, at.reversed};
      }
    }
  }

  const Brep& solid_;
  const SweepFrame& frame_;
  double tolerance_;
  std::vector<std::optional<double>> level_;
  UnionFind vertex_sets_;
  std::map<int, Eigen::Vector2d> drawn_at_;
  std::vector<Strip> strips_;
  std::set<FaceId> around_;    // walls of rings that move
  std::set<EdgeId> on_rings_;  // and their edges
  Tracks result_;
};

}  // namespace

Tracks tracks(const Brep& solid, const SweepFrame& frame) {
  return Tracker(solid, frame).make();
}

double growth(const RingTrack& track, double height) {
  return at_height(track.at, height) / track.at.front().second;
}

Eigen::Vector2d place(const VertexTrack& track, double height) {
  return at_height(track.at, height);
}

}  // namespace isopatch::segmentation
