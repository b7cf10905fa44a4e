#include "segmentation/sweeps/internal/swept_drawing.hpp"

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/overlay.hpp"
#include "segmentation/sweeps/internal/roof.hpp"

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

struct Floor {
  FaceId face;
  double height;
  bool looks_up;
};

bool is_cone(const Brep& solid, FaceId face) {
  const auto carrier = solid.carrier(face);
  return carrier && carrier->kind == geometry::SurfaceKind::cone;
}

/// Edges of roofs in upright planes are drawn as lines.
void redraw_roofs(const Brep& solid, const SweepFrame& frame, geometry::Redrawn& redrawn) {
  for (const FaceId floor : frame.floors) {
    if (!is_cone(solid, floor)) continue;
    for (const auto& loop : solid.face(floor).loops)
      for (const geometry::EdgeUse& use : loop)
        if (solid.edge(use.edge).kind != geometry::CurveKind::circle)
          redrawn[use.edge] = std::array{frame.point(frame.flat(solid.point(use.edge, 0)), 0),
                                         frame.point(frame.flat(solid.point(use.edge, 1)), 0)};
  }
}

std::vector<Floor> floors_by_height(const Brep& solid, const SweepFrame& frame) {
  std::vector<Floor> result;
  for (const FaceId face : frame.floors) {
    if (is_cone(solid, face)) {
      const Roof roof(solid, frame, face);
      result.push_back({face, roof.top(), roof.looks_up()});
      continue;
    }
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

/// @param covering  numbers of the frame's floors that are over a region
std::vector<Slab> slabs_at(const SweepFrame& frame, const std::vector<Floor>& floors,
                           const std::vector<int>& covering) {
  std::vector<Slab> result;
  bool open = false;
  for (const Floor& floor : floors) {
    if (std::none_of(covering.begin(), covering.end(), [&](int number) {
          return frame.floors[static_cast<std::size_t>(number)] == floor.face;
        }))
      continue;
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

SweptDrawing swept_drawing(const Brep& solid, const SweepFrame& frame,
                           const std::vector<std::array<Eigen::Vector3d, 2>>& lines) {
  Tracks moving = tracks(solid, frame);
  redraw_roofs(solid, frame, moving.redrawn);
  std::vector<std::array<Eigen::Vector3d, 2>> flat;
  for (const auto& [start, end] : lines)
    flat.push_back({frame.point(frame.flat(start), 0), frame.point(frame.flat(end), 0)});
  geometry::Overlay laid =
      geometry::overlay(solid, frame.floors, frame.origin, frame.along, moving.redrawn, flat);
  SweptDrawing result{std::move(moving), std::move(laid.sheet), {}, {}};
  draw_edges(result.sheet, frame, result.profile);
  const std::vector<Floor> floors = floors_by_height(solid, frame);
  for (std::size_t r = 0; r < result.sheet.faces().size(); ++r) {
    ProfileRegion region{result.sheet.faces()[r].loops, true};
    std::stable_sort(region.loops.begin(), region.loops.end(), [&](const auto& a, const auto& b) {
      return twice_area(result.profile, a) > twice_area(result.profile, b);
    });
    result.slabs.push_back(slabs_at(frame, floors, laid.covered_by[r]));
    region.wanted = !result.slabs.back().empty();
    result.profile.regions.push_back(std::move(region));
  }
  return result;
}

}  // namespace isopatch::segmentation
