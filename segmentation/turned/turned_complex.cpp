#include "segmentation/turned/internal/turned_complex.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/turned/internal/surfaces.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CurveId;
using geometry::EdgeUse;
using geometry::NurbsCurve;
using geometry::PlaneSurface;
using geometry::SurfaceId;

/// Something of the drawing, and the number of its meridian or sector.
using Turned = std::pair<int, int>;

void turn_around(std::vector<EdgeUse>& loop) {
  std::reverse(loop.begin(), loop.end());
  for (EdgeUse& use : loop) use.reversed = !use.reversed;
}

/// Makes every vertex, edge and face once.
class TurnedComplex {
 public:
  TurnedComplex(const Brep& solid, const TurnedFrame& frame, const TurnedDrawing& drawing, int sectors)
      : solid_(solid),
        frame_(frame),
        drawing_(drawing),
        sectors_(sectors),
        beside_(drawing.curves.size(), 0) {
    for (const Quad& quad : drawing.quads.quads)
      for (const EdgeUse& side : quad.sides) ++beside_[static_cast<std::size_t>(side.edge.value)];
    for (std::size_t s = 0; s < drawing.columns.size(); ++s) {
      const CoreStrip& strip = drawing.half.strips[s];
      for (const int edge : drawing.columns[s]) {
        ++beside_[static_cast<std::size_t>(edge)];
        core_.emplace(drawn(edge).start, nullptr);
        core_.emplace(drawn(edge).end, nullptr);
      }
      for (const CoreEnd* end : {&strip.low, &strip.high}) core_[end->vertex] = end;
    }
  }

  CellComplex make() {
    for (int q = 0; q < static_cast<int>(drawing_.quads.quads.size()); ++q)
      for (int s = 0; s < sectors_; ++s) add_cell(q, s);
    for (const std::vector<int>& column : drawing_.columns)
      for (std::size_t i = 0; i < column.size(); ++i) add_core_cell(column, i);
    return std::move(complex_);
  }

 private:
  const QuadEdge& drawn(int edge) const { return drawing_.quads.edges[static_cast<std::size_t>(edge)]; }
  const NurbsCurve& curve(int edge) const { return drawing_.curves[static_cast<std::size_t>(edge)]; }
  const Eigen::Vector2d& flat(int vertex) const { return drawing_.places[static_cast<std::size_t>(vertex)]; }
  int next(int meridian) const { return frame_.is_whole() ? (meridian + 1) % sectors_ : meridian + 1; }
  double angle(int meridian) const { return frame_.sweep * meridian / sectors_; }
  double tolerance() const { return 1e-9 * solid_.size(); }
  bool is_core(int vertex) const { return core_.contains(vertex); }
  const std::optional<Eigen::Vector3d>* sphere_at(int vertex) const {
    const auto found = core_.find(vertex);
    return found != core_.end() && found->second && found->second->centre ? &found->second->centre : nullptr;
  }

  VertexId vertex(int number, int meridian) {
    const auto [found, fresh] =
        vertices_.try_emplace({number, meridian}, static_cast<int>(complex_.vertices.size()));
    if (fresh) complex_.vertices.push_back(frame_.point(flat(number), angle(meridian)));
    return found->second;
  }

  EdgeId add_edge(NurbsCurve shape, VertexId from, VertexId to) {
    complex_.curves.push_back({std::move(shape)});
    complex_.edges.push_back({CurveId(static_cast<int>(complex_.curves.size()) - 1), 0, 1, from, to});
    return EdgeId(static_cast<int>(complex_.edges.size()) - 1);
  }

  EdgeId meridian_edge(int number, int meridian) {
    const auto known = meridian_edges_.find({number, meridian});
    if (known != meridian_edges_.end()) return known->second;
    const VertexId from = vertex(drawn(number).start, meridian), to = vertex(drawn(number).end, meridian);
    return meridian_edges_[{number, meridian}] =
               add_edge(frame_.turned(curve(number), angle(meridian)), from, to);
  }

  /// From one meridian to the next: an arc, a chord beside the column, a great circle where that ends on a
  /// sphere.
  EdgeId around(int number, int sector) {
    const auto known = around_.find({number, sector});
    if (known != around_.end()) return known->second;
    const VertexId from = vertex(number, sector), to = vertex(number, next(sector));
    const Eigen::Vector3d a = complex_.vertex(from), b = complex_.vertex(to);
    NurbsCurve shape = geometry::segment(a, b);
    if (const auto* centre = sphere_at(number)) {
      const Eigen::Vector3d u = a - **centre, v = b - **centre;
      shape = geometry::arc_about(**centre, u.cross(v), a,
                                  Angle::radians(std::atan2(u.cross(v).norm(), u.dot(v))));
    } else if (!is_core(number)) {
      shape = geometry::arc_about(frame_.origin, frame_.along, a, Angle::radians(frame_.sweep / sectors_));
    }
    return around_[{number, sector}] = add_edge(std::move(shape), from, to);
  }

  const NurbsCurve& shape(EdgeId edge) const {
    return std::get<NurbsCurve>(complex_.curve(complex_.edge(edge).curve).shape);
  }

  SurfaceId add_surface(geometry::CellSurface surface) {
    complex_.surfaces.push_back(std::move(surface));
    return SurfaceId(static_cast<int>(complex_.surfaces.size()) - 1);
  }

  FaceId add_face(geometry::CellFace face) {
    complex_.faces.push_back(std::move(face));
    return FaceId(static_cast<int>(complex_.faces.size()) - 1);
  }

  void trace(EdgeId edge, SurfaceId surface, NurbsCurve domain) {
    complex_.curves[static_cast<std::size_t>(complex_.edge(edge).curve.value)].traces.push_back(
        {surface, std::move(domain)});
  }

  /// The face of the solid at a place, of some.
  FaceId origin_at(const std::vector<FaceId>& faces, const Eigen::Vector3d& place) const {
    if (faces.size() == 1) return faces.front();
    for (const FaceId face : faces) {
      const geometry::FaceProjection nearest = solid_.project(face, place);
      if (nearest.distance < 1e-6 * solid_.size() && solid_.contains(face, nearest.uv)) return face;
    }
    throw Error(ErrorCode::unsupported, fmt::format("no face of the solid is at ({:.6g}, {:.6g}, {:.6g}) m",
                                                    place.x(), place.y(), place.z()));
  }

  /// Of a quadrilateral at a meridian. Looks back, but the last one of what is no whole turn out of the
  /// solid.
  FaceId section(int quad, int meridian) {
    const auto known = sections_.find({quad, meridian});
    if (known != sections_.end()) return known->second;
    const bool last = !frame_.is_whole() && meridian == sectors_;
    const auto [plane, fresh] = planes_.try_emplace(meridian, SurfaceId(0));
    if (fresh) {
      const Eigen::Vector3d out = frame_.point({1, 0}, angle(meridian)) - frame_.origin;
      plane->second = add_surface(last ? PlaneSurface{frame_.origin, frame_.along, out}
                                       : PlaneSurface{frame_.origin, out, frame_.along});
    }
    geometry::CellFace face{plane->second, {}, {}};
    const Quad& shown = drawing_.quads.quads[static_cast<std::size_t>(quad)];
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const EdgeUse& side : shown.sides) {
      face.loop.push_back({meridian_edge(side.edge.value, meridian), side.reversed});
      middle += frame_.flat(curve(side.edge.value).point(geometry::Parameter<1>(0.5))) / 2;
      middle -= flat(side.reversed ? drawn(side.edge.value).end : drawn(side.edge.value).start) / 4;
    }
    if (last) turn_around(face.loop);
    if (!frame_.is_whole() && (last || meridian == 0))
      face.origin = origin_at(last ? frame_.last : frame_.first, frame_.point(middle, angle(meridian)));
    return sections_[{quad, meridian}] = add_face(std::move(face));
  }

  /// Over an edge of the drawing in a sector; looks to its right, or out of the solid.
  FaceId wall(EdgeUse side, int sector) {
    const int number = side.edge.value;
    const auto known = walls_.find({number, sector});
    if (known != walls_.end()) return known->second;
    const bool outer = beside_[static_cast<std::size_t>(number)] == 1;
    const bool turned = outer && side.reversed;
    const int from = turned ? drawn(number).end : drawn(number).start;
    const int to = turned ? drawn(number).start : drawn(number).end;
    const EdgeId low = around(from, sector), high = around(to, sector);
    const EdgeId here = meridian_edge(number, sector), there = meridian_edge(number, next(sector));
    geometry::CellFace face{SurfaceId(0), {{low, false}, {there, turned}, {high, true}, {here, !turned}}, {}};
    const NurbsCurve along = turned ? geometry::reversed(curve(number), 0) : curve(number);
    if (outer) {
      const auto& faces =
          drawing_.half.outside.curves[static_cast<std::size_t>(drawn(number).profile_edge)].faces;
      const Eigen::Vector3d middle = along.point(geometry::Parameter<1>(0.5));
      face.origin =
          origin_at(faces, frame_.point(frame_.flat(middle), (sector + 0.5) * frame_.sweep / sectors_));
    }
    face.surface = wall_surface(along, {from, to}, {low, high, here, there}, turned, outer, sector);
    return walls_[{number, sector}] = add_face(std::move(face));
  }

  struct Around {
    EdgeId low, high, here, there;
  };

  SurfaceId wall_surface(const NurbsCurve& along, std::array<int, 2> ends, const Around& edges, bool turned,
                         bool outer, int sector) {
    const bool straight = along.degree(0) == 1 && along.size() == 2;
    const bool beside_core = is_core(ends[0]) || is_core(ends[1]);
    if (straight && std::abs(flat(ends[0])[1] - flat(ends[1])[1]) < tolerance()) {
      const bool up = flat(ends[0])[0] > flat(ends[1])[0];
      return add_surface(
          PlaneSurface{frame_.point({0, flat(ends[0])[1]}, 0), frame_.x, up ? frame_.y : -frame_.y});
    }
    if (outer && beside_core)
      return sphere_surface(is_core(ends[0]) ? ends[0] : ends[1],
                            {edges.low, edges.high, edges.here, edges.there});
    SurfaceId made(0);
    if (!beside_core) {
      made = add_surface(turned_surface(frame_.turned(along, angle(sector)), frame_.origin, frame_.along,
                                        frame_.sweep / sectors_));
    } else {
      if (const auto plane = plane_through(edges)) return add_surface(*plane);
      made = add_surface(geometry::ruled(shape(edges.low), shape(edges.high)));
    }
    const double start = turned ? 1 : 0;
    trace(edges.low, made, geometry::segment({0, 0, 0}, {1, 0, 0}));
    trace(edges.high, made, geometry::segment({0, 1, 0}, {1, 1, 0}));
    trace(edges.here, made, geometry::segment({0, start, 0}, {0, 1 - start, 0}));
    trace(edges.there, made, geometry::segment({1, start, 0}, {1, 1 - start, 0}));
    return made;
  }

  /// Of chords below and above.
  std::optional<PlaneSurface> plane_through(const Around& edges) const {
    for (const EdgeId edge : {edges.low, edges.high})
      if (shape(edge).degree(0) != 1) return std::nullopt;
    const Eigen::Vector3d a = shape(edges.low).control_points().col(0),
                          b = shape(edges.low).control_points().col(1);
    const Eigen::Vector3d up = shape(edges.high).control_points().col(0) - a;
    const Eigen::Vector3d x = (b - a).normalized();
    return PlaneSurface{a, x, (up - up.dot(x) * x).normalized()};
  }

  /// Around the middle of what some edges bound on the sphere at a corner of the column.
  SurfaceId sphere_surface(int corner, const std::vector<EdgeId>& edges) {
    const CoreEnd& end = *core_.at(corner);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const EdgeId edge : edges) middle += shape(edge).point(geometry::Parameter<1>(0.5)) - *end.centre;
    const double radius = (frame_.point(flat(corner), 0) - *end.centre).norm();
    const geometry::FaceProjection on =
        solid_.project(end.faces.front(), *end.centre + middle.normalized() * radius);
    const bool inwards = solid_.outward_normal(end.faces.front(), on.uv).dot(middle) < 0;
    const SpherePatch patch(*end.centre, radius, middle.normalized(), inwards);
    std::vector<NurbsCurve> traces;
    double reach = 0;
    for (const EdgeId edge : edges) {
      traces.push_back(patch.trace(shape(edge)));
      reach = std::max(reach, traces.back().control_points().cwiseAbs().maxCoeff());
    }
    const SurfaceId made = add_surface(patch.surface(1.25 * reach));
    for (std::size_t i = 0; i < edges.size(); ++i) trace(edges[i], made, std::move(traces[i]));
    return made;
  }

  /// Across the column at a corner; looks up, or out of the solid at its low end.
  FaceId square(int corner, bool lowest) {
    const auto known = squares_.find(corner);
    if (known != squares_.end()) return known->second;
    std::vector<EdgeId> edges;
    geometry::CellFace face{SurfaceId(0), {}, {}};
    for (int s = 0; s < sectors_; ++s) {
      edges.push_back(around(corner, s));
      face.loop.push_back({edges.back(), false});
    }
    if (lowest) turn_around(face.loop);
    const CoreEnd* end = core_.at(corner);
    const double height = flat(corner)[1];
    if (end) face.origin = end->faces.front();
    if (sphere_at(corner))
      face.surface = sphere_surface(corner, edges);
    else
      face.surface = add_surface(PlaneSurface{frame_.point({0, height}, 0), frame_.x,
                                              lowest ? Eigen::Vector3d(-frame_.y) : frame_.y});
    return squares_[corner] = add_face(std::move(face));
  }

  void add_cell(int quad, int sector) {
    geometry::Cell cell;
    const auto add = [&](FaceId face, bool reversed) {
      cell.faces.push_back({face, reversed, static_cast<int>(cell.faces.size())});
    };
    add(section(quad, sector), false);
    add(section(quad, next(sector)), frame_.is_whole() || sector + 1 < sectors_);
    for (const EdgeUse& side : drawing_.quads.quads[static_cast<std::size_t>(quad)].sides) {
      const bool outer = beside_[static_cast<std::size_t>(side.edge.value)] == 1;
      add(wall(side, sector), !outer && side.reversed);
    }
    complex_.cells.push_back(std::move(cell));
  }

  /// Beside a piece of the column's line.
  void add_core_cell(const std::vector<int>& column, std::size_t piece) {
    geometry::Cell cell;
    const auto add = [&](FaceId face, bool reversed) {
      cell.faces.push_back({face, reversed, static_cast<int>(cell.faces.size())});
    };
    const bool lowest = piece == 0;
    add(square(drawn(column[piece]).start, lowest), !lowest);
    add(square(drawn(column[piece]).end, false), false);
    for (int s = 0; s < sectors_; ++s)  // the line runs up, so that its right is outside of the column
      add(wall({EdgeId(column[piece]), false}, s), false);
    complex_.cells.push_back(std::move(cell));
  }

  const Brep& solid_;
  const TurnedFrame& frame_;
  const TurnedDrawing& drawing_;
  int sectors_;
  std::vector<int> beside_;             // cells at edges of the drawing
  std::map<int, const CoreEnd*> core_;  // vertices beside columns; where these end
  CellComplex complex_;
  std::map<Turned, VertexId> vertices_;
  std::map<Turned, EdgeId> meridian_edges_, around_;
  std::map<Turned, FaceId> sections_, walls_;
  std::map<int, SurfaceId> planes_;
  std::map<int, FaceId> squares_;
};

}  // namespace

CellComplex turned_complex(const Brep& solid, const TurnedFrame& frame, const TurnedDrawing& drawing,
                           int sectors) {
  return TurnedComplex(solid, frame, drawing, sectors).make();
}

}  // namespace isopatch::segmentation
