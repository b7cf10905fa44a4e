#include "segmentation/sweeps/internal/swept_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/overlay.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::EdgeUse;

/// As many points as show the shape of a curve.
int pieces_of(geometry::CurveKind kind) {
  return kind == geometry::CurveKind::line ? 1 : 48;
}

/// Edges of the sheet; a closed one has no vertex, unless others meet there.
void draw_edges(const Brep& sheet, const SweepFrame& frame, Profile& profile) {
  std::vector<int> ends(static_cast<std::size_t>(sheet.vertices().cols()));
  for (const geometry::BrepEdge& edge : sheet.edges())
    for (const VertexId end : {edge.start, edge.end}) ++ends[static_cast<std::size_t>(end.value)];
  std::vector<int> numbers(ends.size(), -1);
  const auto number = [&](VertexId vertex) {
    int& known = numbers[static_cast<std::size_t>(vertex.value)];
    if (known < 0) {
      known = static_cast<int>(profile.vertices.size());
      profile.vertices.push_back(frame.flat(sheet.vertex(vertex)));
    }
    return known;
  };
  for (std::size_t e = 0; e < sheet.edges().size(); ++e) {
    const geometry::BrepEdge& edge = sheet.edges()[e];
    ProfileEdge drawn;
    if (edge.start != edge.end || ends[static_cast<std::size_t>(edge.start.value)] > 2)
      drawn = {number(edge.start), number(edge.end), {}};
    const int pieces = pieces_of(edge.kind);
    for (int i = 0; i <= pieces; ++i)
      drawn.points.push_back(
          frame.flat(sheet.point(EdgeId(static_cast<int>(e)), static_cast<double>(i) / pieces)));
    profile.edges.push_back(std::move(drawn));
  }
}

/// Twice its signed area.
double twice_area(const Profile& profile, const std::vector<EdgeUse>& loop) {
  double result = 0;
  for (const EdgeUse& use : loop) {
    const auto& points = profile.edges[static_cast<std::size_t>(use.edge.value)].points;
    double part = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      part += points[i - 1].x() * points[i].y() - points[i - 1].y() * points[i].x();
    result += use.reversed ? -part : part;
  }
  return result;
}

/// A point well inside a region: in the middle of the widest gap that some horizontal lines find.
Eigen::Vector2d point_inside(const Profile& profile, const ProfileRegion& region) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> chords;
  double low = 0, high = 0;
  for (const auto& loop : region.loops)
    for (const EdgeUse& use : loop) {
      const auto& points = profile.edges[static_cast<std::size_t>(use.edge.value)].points;
      for (std::size_t i = 1; i < points.size(); ++i) {
        chords.emplace_back(points[i - 1], points[i]);
        const double bottom = std::min(points[i - 1].y(), points[i].y());
        const double top = std::max(points[i - 1].y(), points[i].y());
        low = chords.size() == 1 ? bottom : std::min(low, bottom);
        high = chords.size() == 1 ? top : std::max(high, top);
      }
    }
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double widest = -1;
  constexpr int lines = 29;
  for (int i = 0; i < lines; ++i) {
    const double y = low + (high - low) * (i + 0.4837) / lines;  // hardly through vertices
    std::vector<double> crossings;
    for (const auto& [a, b] : chords)
      if ((a.y() < y) != (b.y() < y))
        crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 1; k < crossings.size(); k += 2) {
      // A thin strip is judged by what is above and below it too.
      const double width = std::min(crossings[k] - crossings[k - 1], 10 * (high - low));
      if (width > widest) {
        widest = width;
        best = {(crossings[k] + crossings[k - 1]) / 2, y};
      }
    }
  }
  return best;
}

struct Floor {
  FaceId face;
  double height;
  bool looks_up;
};

std::vector<Floor> floors_by_height(const Brep& solid, const SweepFrame& frame) {
  std::vector<Floor> result;
  for (const FaceId face : frame.floors) {
    const geometry::DomainBox domain = solid.domain(face);
    result.push_back({face, frame.height(solid.point(face, domain.low)),
                      solid.outward_normal(face, domain.low).dot(frame.along) > 0});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Floor& a, const Floor& b) { return a.height < b.height; });
  // One height for floors that are at one up to round-off.
  for (std::size_t i = 1; i < result.size(); ++i)
    if (result[i].height - result[i - 1].height < 1e-7 * solid.size())
      result[i].height = result[i - 1].height;
  return result;
}

bool covers(const Brep& solid, FaceId face, const Eigen::Vector3d& point) {
  const geometry::FaceProjection nearest = solid.project(face, point);
  return nearest.distance < 1e-7 * solid.size() && solid.contains(face, nearest.uv);
}

std::vector<Slab> slabs_at(const Brep& solid, const SweepFrame& frame, const std::vector<Floor>& floors,
                           const Eigen::Vector2d& place) {
  std::vector<Slab> result;
  bool open = false;
  for (const Floor& floor : floors) {
    if (!covers(solid, floor.face, frame.point(place, floor.height))) continue;
    if (floor.looks_up != open)
      throw Error(ErrorCode::unsupported, "its floors do not bound material by turns");
    if (open) {
      result.back().high = floor.height;
      result.back().top = floor.face;
    } else {
      result.push_back({floor.height, floor.height, floor.face, floor.face});
    }
    open = !open;
  }
  if (open) throw Error(ErrorCode::unsupported, "its floors do not bound material by turns");
  return result;
}

}  // namespace

SweptDrawing swept_drawing(const Brep& solid, const SweepFrame& frame) {
  SweptDrawing result{geometry::overlay(solid, frame.floors, frame.origin, frame.along), {}, {}};
  draw_edges(result.sheet, frame, result.profile);
  const std::vector<Floor> floors = floors_by_height(solid, frame);
  for (const geometry::BrepFace& face : result.sheet.faces()) {
    ProfileRegion region{face.loops, true};
    std::stable_sort(region.loops.begin(), region.loops.end(), [&](const auto& a, const auto& b) {
      return twice_area(result.profile, a) > twice_area(result.profile, b);
    });
    result.slabs.push_back(slabs_at(solid, frame, floors, point_inside(result.profile, region)));
    region.wanted = !result.slabs.back().empty();
    result.profile.regions.push_back(std::move(region));
  }
  return result;
}

}  // namespace isopatch::segmentation
