#include "segmentation/sweeps/internal/column_complex.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/sweeps/internal/piece_of_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CurveId;
using geometry::EdgeUse;
using geometry::NurbsCurve;
using geometry::PlaneSurface;
using geometry::SurfaceId;

/// Something between two levels over an edge or a vertex of the drawing.
using Upright = std::tuple<int, int, int>;  // number, low, high
/// Something in a level.
using Flat = std::pair<int, int>;  // number, level

NurbsCurve moved(const NurbsCurve& curve, const Eigen::Vector3d& by) {
  return NurbsCurve(curve.knots(), curve.control_points().colwise() + by, curve.weights());
}

NurbsCurve line_in_domain(double u0, double v0, double u1, double v1) {
  return geometry::segment({u0, v0, 0}, {u1, v1, 0});
}

/// Makes every vertex, edge and face once, by its number in the drawing and its levels.
class ColumnComplex {
 public:
  ColumnComplex(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                const Quadrangulation& quads, const Layers& layers)
      : solid_(solid), frame_(frame), quads_(quads), layers_(layers), places_(quads.vertices) {
    draw_curves(drawing.sheet);
    for (std::size_t q = 0; q < quads.quads.size(); ++q)
      for (const Layer& layer : layers.columns[q])
        for (const EdgeUse& side : quads.quads[q].sides) ++cells_at_[{side.edge.value, layer.low, layer.high}];
  }

  CellComplex make() {
    for (std::size_t q = 0; q < quads_.quads.size(); ++q)
      for (const Layer& layer : layers_.columns[q]) add_cell(static_cast<int>(q), layer);
    return std::move(complex_);
  }

 private:
  /// At height 0. Vertices on curves are where these end.
  void draw_curves(const Brep& sheet) {
    curves_.resize(quads_.edges.size());
    for (std::size_t e = 0; e < quads_.edges.size(); ++e) {
      const QuadEdge& edge = quads_.edges[e];
      if (edge.profile_edge < 0) continue;
      curves_[e] = piece_of_curve(sheet, EdgeId(edge.profile_edge), edge.low, edge.high);
      place(edge.start) = frame_.flat(curves_[e].point(curves_[e].low()));
      place(edge.end) = frame_.flat(curves_[e].point(curves_[e].high()));
    }
    for (std::size_t e = 0; e < quads_.edges.size(); ++e)
      if (const QuadEdge& edge = quads_.edges[e]; edge.profile_edge < 0)
        curves_[e] =
            geometry::segment(frame_.point(place(edge.start), 0), frame_.point(place(edge.end), 0));
  }

  Eigen::Vector2d& place(int vertex) { return places_[static_cast<std::size_t>(vertex)]; }
  const QuadEdge& drawn(int edge) const { return quads_.edges[static_cast<std::size_t>(edge)]; }
  const NurbsCurve& curve(int edge) const { return curves_[static_cast<std::size_t>(edge)]; }
  double height(int level) const { return layers_.levels[static_cast<std::size_t>(level)]; }

  VertexId vertex(int number, int level) {
    const auto [found, fresh] =
        vertices_.try_emplace({number, level}, static_cast<int>(complex_.vertices.size()));
    if (fresh) complex_.vertices.push_back(frame_.point(place(number), height(level)));
    return found->second;
  }

  EdgeId add_edge(NurbsCurve shape, VertexId from, VertexId to) {
    complex_.curves.push_back({std::move(shape)});
    complex_.edges.push_back({CurveId(static_cast<int>(complex_.curves.size()) - 1), 0, 1, from, to});
    return EdgeId(static_cast<int>(complex_.edges.size()) - 1);
  }

  EdgeId level_edge(int number, int level) {
    const auto known = level_edges_.find({number, level});
    if (known != level_edges_.end()) return known->second;
    const VertexId from = vertex(drawn(number).start, level), to = vertex(drawn(number).end, level);
    const EdgeId made = add_edge(moved(curve(number), height(level) * frame_.along), from, to);
    return level_edges_[{number, level}] = made;
  }

  EdgeId upright_edge(int number, int low, int high) {
    const auto known = upright_edges_.find({number, low, high});
    if (known != upright_edges_.end()) return known->second;
    const VertexId from = vertex(number, low), to = vertex(number, high);
    const EdgeId made = add_edge(geometry::segment(complex_.vertex(from), complex_.vertex(to)), from, to);
    return upright_edges_[{number, low, high}] = made;
  }

  SurfaceId add_surface(geometry::CellSurface surface) {
    complex_.surfaces.push_back(std::move(surface));
    return SurfaceId(static_cast<int>(complex_.surfaces.size()) - 1);
  }

  FaceId add_face(geometry::CellFace face) {
    complex_.faces.push_back(std::move(face));
    return FaceId(static_cast<int>(complex_.faces.size()) - 1);
  }

  /// Of a quadrilateral in a level; looks up, or out of the solid.
  FaceId level_face(int quad, int level, std::optional<FaceId> origin, bool looks_up) {
    const auto known = level_faces_.find({quad, level});
    if (known != level_faces_.end()) return known->second;
    const auto [surface, fresh] = planes_.try_emplace({level, looks_up}, SurfaceId(0));
    if (fresh) {
      const Eigen::Vector3d y = looks_up ? frame_.y : Eigen::Vector3d(-frame_.y);
      surface->second =
          add_surface(PlaneSurface{frame_.point(Eigen::Vector2d::Zero(), height(level)), frame_.x, y});
    }
    geometry::CellFace face{surface->second, {}, origin};
    for (const EdgeUse& side : quads_.quads[static_cast<std::size_t>(quad)].sides)
      face.loop.push_back({level_edge(side.edge.value, level), side.reversed});
    if (!looks_up) turn(face.loop);
    return level_faces_[{quad, level}] = add_face(std::move(face));
  }

  static void turn(std::vector<EdgeUse>& loop) {
    std::reverse(loop.begin(), loop.end());
    for (EdgeUse& use : loop) use.reversed = !use.reversed;
  }

  /// Over an edge of the drawing, looks to its right, or out of the solid.
  FaceId wall(EdgeUse side, int low, int high) {
    const int number = side.edge.value;
    const auto known = walls_.find({number, low, high});
    if (known != walls_.end()) return known->second;
    const bool outer = cells_at_.at({number, low, high}) == 1;
    const bool turned = outer && side.reversed;
    const EdgeId bottom = level_edge(number, low), top = level_edge(number, high);
    const EdgeId at_start = upright_edge(drawn(number).start, low, high);
    const EdgeId at_end = upright_edge(drawn(number).end, low, high);
    const NurbsCurve along =
        moved(turned ? reversed(curve(number), 0) : curve(number), height(low) * frame_.along);
    const Eigen::Vector3d up = (height(high) - height(low)) * frame_.along;
    geometry::CellFace face;
    if (along.degree(0) == 1 && along.size() == 2) {
      const Eigen::Vector3d from = along.point(along.low());
      face.surface = add_surface(
          PlaneSurface{from, (along.point(along.high()) - from).normalized(), frame_.along});
    } else {
      face.surface = add_surface(extruded(along, up));
      const double start = turned ? 1 : 0, end = 1 - start;
      trace(bottom, face.surface, line_in_domain(start, 0, end, 0));
      trace(top, face.surface, line_in_domain(start, 1, end, 1));
      trace(at_start, face.surface, line_in_domain(start, 0, start, 1));
      trace(at_end, face.surface, line_in_domain(end, 0, end, 1));
    }
    face.loop = {{bottom, false}, {at_end, false}, {top, true}, {at_start, true}};
    if (turned) turn(face.loop);
    if (outer) face.origin = wall_of_solid(along.point(Eigen::Matrix<double, 1, 1>(0.5)) + up / 2);
    return walls_[{number, low, high}] = add_face(std::move(face));
  }

  void trace(EdgeId edge, SurfaceId surface, NurbsCurve domain) {
    complex_.curves[static_cast<std::size_t>(complex_.edge(edge).curve.value)].traces.push_back(
        {surface, std::move(domain)});
  }

  FaceId wall_of_solid(const Eigen::Vector3d& point) const {
    for (const FaceId face : frame_.walls) {
      const geometry::FaceProjection nearest = solid_.project(face, point);
      if (nearest.distance < 1e-6 * solid_.size() && solid_.contains(face, nearest.uv)) return face;
    }
    throw Error(ErrorCode::unsupported, fmt::format("no wall of the solid is at ({:.6g}, {:.6g}, {:.6g}) m",
                                                    point.x(), point.y(), point.z()));
  }

  void add_cell(int quad, const Layer& layer) {
    geometry::Cell cell;
    const auto add = [&](FaceId face, bool reversed) {
      cell.faces.push_back({face, reversed, static_cast<int>(cell.faces.size())});
    };
    // Between two cells the one below makes the face that both look at.
    add(level_face(quad, layer.low, layer.bottom, !layer.bottom), !layer.bottom);
    add(level_face(quad, layer.high, layer.top, true), false);
    for (const EdgeUse& side : quads_.quads[static_cast<std::size_t>(quad)].sides) {
      const bool outer = cells_at_.at({side.edge.value, layer.low, layer.high}) == 1;
      add(wall(side, layer.low, layer.high), !outer && side.reversed);
    }
    complex_.cells.push_back(std::move(cell));
  }

  const Brep& solid_;
  const SweepFrame& frame_;
  const Quadrangulation& quads_;
  const Layers& layers_;
  std::vector<Eigen::Vector2d> places_;  // of the drawing's vertices
  std::vector<NurbsCurve> curves_;       // of its edges, at height 0
  std::map<Upright, int> cells_at_;      // walls
  CellComplex complex_;
  std::map<Flat, VertexId> vertices_;
  std::map<Flat, EdgeId> level_edges_;
  std::map<Flat, FaceId> level_faces_;
  std::map<std::pair<int, bool>, SurfaceId> planes_;
  std::map<Upright, EdgeId> upright_edges_;
  std::map<Upright, FaceId> walls_;
};

}  // namespace

CellComplex column_complex(const Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                           const Quadrangulation& quads, const Layers& layers) {
  return ColumnComplex(solid, frame, drawing, quads, layers).make();
}

}  // namespace isopatch::segmentation
