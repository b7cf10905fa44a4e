#include "segmentation/profiles/internal/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/internal/triangulate.hpp"

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;
using geometry::EdgeUse;

namespace {

/// The pieces of each edge, in its direction.
std::vector<std::vector<Side>> divided_edges(const Profile& profile, const std::vector<Curve>& curves,
                                             const CutPlaces& places, std::vector<Node>& nodes) {
  std::vector<std::vector<Side>> result(curves.size());
  for (std::size_t e = 0; e < curves.size(); ++e) {
    const int number = static_cast<int>(e);
    if (curves[e].closed() && places[e].empty()) continue;
    std::vector<std::pair<double, int>> cuts;
    if (!curves[e].closed()) cuts.emplace_back(0.0, profile.edges[e].start);
    for (const double at : places[e]) {
      cuts.emplace_back(at, static_cast<int>(nodes.size()));
      nodes.push_back({curves[e].at(at), false, number, at});
    }
    if (curves[e].closed())
      cuts.emplace_back(cuts.front().first + 1, cuts.front().second);
    else
      cuts.emplace_back(1.0, profile.edges[e].end);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      result[e].push_back(
          {cuts[i].second, cuts[i + 1].second, number, cuts[i].first, cuts[i + 1].first, false});
  }
  return result;
}

std::vector<Side> pieces_of(const std::vector<std::vector<Side>>& edges, const std::vector<EdgeUse>& loop) {
  std::vector<Side> result;
  for (const EdgeUse& use : loop) {
    const std::vector<Side>& pieces = edges[static_cast<std::size_t>(use.edge.value)];
    if (use.reversed)
      std::transform(pieces.rbegin(), pieces.rend(), std::back_inserter(result),
                     [](const Side& piece) { return turned(piece); });
    else
      result.insert(result.end(), pieces.begin(), pieces.end());
  }
  return result;
}

std::optional<std::vector<Cell>> triangles_of_region(const Profile& profile, int region,
                                                     const std::vector<std::vector<Side>>& edges,
                                                     const std::vector<Vector2d>& points) {
  std::map<std::pair<int, int>, Side> outline;
  std::vector<std::vector<int>> loops;
  for (const std::vector<EdgeUse>& loop : profile.regions[static_cast<std::size_t>(region)].loops) {
    loops.emplace_back();
    for (const Side& side : pieces_of(edges, loop)) {
      loops.back().push_back(side.from);
      outline[{side.from, side.to}] = side;
    }
  }
  const auto triangles = triangulate(points, loops);
  if (!triangles) return std::nullopt;
  std::vector<Cell> result;
  for (const std::array<int, 3>& corners : *triangles) {
    Cell cell{region, 3, {}};
    for (int k = 0; k < 3; ++k) {
      const int from = corners[k], to = corners[(k + 1) % 3];
      const auto found = outline.find({from, to});
      cell.sides[k] = found == outline.end() ? Side{from, to} : found->second;
    }
    result.push_back(cell);
  }
  return result;
}

/// A piece of an outline as a segment.
struct Segment {
  Vector2d a, b;
  std::size_t curve;
  double low, high;
};

std::vector<Segment> segments_of(const std::vector<Curve>& curves, const CutPlaces& places) {
  std::vector<Segment> result;
  for (std::size_t e = 0; e < curves.size(); ++e) {
    std::vector<double> at = places[e];
    if (!curves[e].closed()) at.insert(at.begin(), 0.0);
    at.push_back(curves[e].closed() ? at.front() + 1 : 1.0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
      result.push_back({curves[e].at(at[i]), curves[e].at(at[i + 1]), e, at[i], at[i + 1]});
  }
  return result;
}

/// Halves pieces that meet others as segments but for common ends; whether there were any.
bool refine_where_met(const std::vector<Curve>& curves, CutPlaces& places) {
  const std::vector<Segment> segments = segments_of(curves, places);
  CutPlaces added(curves.size());
  const auto halve = [&](const Segment& s) {
    if (curves[s.curve].straight()) return;
    const double middle = (s.low + s.high) / 2;
    added[s.curve].push_back(middle >= 1 ? middle - 1 : middle);
  };
  const auto near = [](const Vector2d& p, const Vector2d& q, double size) {
    return (p - q).norm() <= 1e-9 * size;
  };
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const Segment &s = segments[i], &t = segments[j];
      const double size = (s.b - s.a).norm() + (t.b - t.a).norm();
      if (near(s.a, t.a, size) || near(s.a, t.b, size) || near(s.b, t.a, size) || near(s.b, t.b, size))
        continue;
      if (!segments_meet(s.a, s.b, t.a, t.b)) continue;
      halve(s);
      halve(t);
    }
  bool any = false;
  for (std::size_t e = 0; e < curves.size(); ++e) {
    any = any || !added[e].empty();
    places[e].insert(places[e].end(), added[e].begin(), added[e].end());
    std::sort(places[e].begin(), places[e].end());
    places[e].erase(std::unique(places[e].begin(), places[e].end()), places[e].end());
  }
  return any;
}

/// Halves a line until its pieces are short beside their distance from points.
void cut_line(const Curve& line, const std::vector<Vector2d>& points, double low, double high,
              std::vector<double>& places) {
  constexpr double shortest = 1.0 / 128, ratio = 3;
  const double middle = (low + high) / 2, length = (high - low) * line.length();
  if (high - low <= shortest) return;
  const Vector2d here = line.at(middle);
  const bool close = std::any_of(points.begin(), points.end(),
                                 [&](const Vector2d& p) { return (p - here).norm() * ratio < length; });
  if (!close) return;
  cut_line(line, points, low, middle, places);
  places.push_back(middle);
  cut_line(line, points, middle, high, places);
}

void cut_lines(const std::vector<Curve>& curves, const std::vector<bool>& fixed, CutPlaces& places) {
  const std::vector<Segment> segments = segments_of(curves, places);
  for (std::size_t e = 0; e < curves.size(); ++e) {
    if (!curves[e].straight() || fixed[e]) continue;
    const Vector2d start = curves[e].at(0), along = curves[e].derivative(0).normalized();
    std::vector<Vector2d> points;  // but for those on the line itself
    for (const Segment& segment : segments) {
      const Vector2d d = segment.a - start;
      if (segment.curve != e && std::abs(along.x() * d.y() - along.y() * d.x()) > 1e-6)
        points.push_back(segment.a);
    }
    cut_line(curves[e], points, 0, 1, places[e]);
  }
}

}  // namespace

CutPlaces even_places(const std::vector<Curve>& curves, const std::vector<bool>& fixed, CutPlaces places,
                      double turn) {
  for (std::size_t e = 0; e < curves.size(); ++e) {
    if (curves[e].straight() || fixed[e]) continue;
    const int pieces = std::max(2, static_cast<int>(std::ceil(curves[e].turning() / turn - 1e-6)));
    for (int i = curves[e].closed() ? 0 : 1; i < pieces; ++i)
      places[e].push_back(static_cast<double>(i) / pieces);
  }
  cut_lines(curves, fixed, places);
  constexpr int rounds = 5;
  for (int round = 0; round < rounds && refine_where_met(curves, places); ++round) {
  }
  return places;
}

CellMesh triangles_of(const Profile& profile, const std::vector<Curve>& curves, const CutPlaces& places) {
  CellMesh result;
  for (const Vector2d& vertex : profile.vertices) result.nodes.push_back({vertex, true, -1, 0});
  const std::vector<std::vector<Side>> edges = divided_edges(profile, curves, places, result.nodes);
  std::vector<Vector2d> points;
  for (const Node& node : result.nodes) points.push_back(node.point);
  for (std::size_t r = 0; r < profile.regions.size(); ++r) {
    if (!profile.regions[r].wanted) continue;
    const auto cells = triangles_of_region(profile, static_cast<int>(r), edges, points);
    if (!cells)
      throw Error(
          ErrorCode::unsupported,
          fmt::format("region {} of the profile cannot be divided: its loops cross or touch each other", r));
    result.cells.insert(result.cells.end(), cells->begin(), cells->end());
  }
  return result;
}

std::optional<RegionOutline> outline_of_region(const Profile& profile, const std::vector<Curve>& curves,
                                               const CutPlaces& places, int region) {
  const auto& loops = profile.regions[static_cast<std::size_t>(region)].loops;
  if (loops.size() != 1) return std::nullopt;
  RegionOutline result;
  for (const Vector2d& vertex : profile.vertices) result.nodes.push_back({vertex, true, -1, 0});
  const std::vector<std::vector<Side>> edges = divided_edges(profile, curves, places, result.nodes);
  for (const Side& side : pieces_of(edges, loops.front())) result.places.push_back({side.from, false, side});
  if (result.places.size() < 2) return std::nullopt;
  return result;
}

}  // namespace isopatch::segmentation::planar
