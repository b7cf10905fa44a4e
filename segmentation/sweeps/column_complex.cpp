#include "segmentation/sweeps/internal/column_complex.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/internal/straight_wall.hpp"

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

/// How far a straight wall may lie off the solid's, as a share of its size: what patches keep to as well.
/// Drafted walls of CAD programs are splines, and their edges run at paces of their own.
constexpr double off_the_wall = 1e-4;

NurbsCurve line_in_domain(double u0, double v0, double u1, double v1) {
  return geometry::segment({u0, v0, 0}, {u1, v1, 0});
}

/// Makes every vertex, edge and face once, by its number in the drawing and its levels.
class ColumnComplex {
 public:
  ColumnComplex(const Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                const MovingDrawing& moving, const Layers& layers)
      : solid_(solid), frame_(frame), quads_(quads), moving_(moving), layers_(layers) {
    for (std::size_t q = 0; q < quads.quads.size(); ++q)
      for (const Layer& layer : layers.columns[q])
        for (const EdgeUse& side : quads.quads[q].sides)
          ++cells_at_[{side.edge.value, layer.low, layer.high}];
  }

  CellComplex make() {
    for (std::size_t q = 0; q < quads_.quads.size(); ++q)
      for (const Layer& layer : layers_.columns[q]) add_cell(static_cast<int>(q), layer);
    return std::move(complex_);
  }

 private:
  const QuadEdge& drawn(int edge) const { return quads_.edges[static_cast<std::size_t>(edge)]; }
  double height(int level) const { return layers_.levels[static_cast<std::size_t>(level)]; }

  VertexId vertex(int number, int level) {
    const auto [found, fresh] =
        vertices_.try_emplace({number, level}, static_cast<int>(complex_.vertices.size()));
    if (fresh) complex_.vertices.push_back(moving_.place(number, height(level)));
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
    const EdgeId made = add_edge(moving_.curve(number, height(level)), from, to);
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
    NurbsCurve below = moving_.curve(number, height(low)), above = moving_.curve(number, height(high));
    if (turned) below = reversed(below, 0), above = reversed(above, 0);
    geometry::CellFace face;
    if (const std::optional<PlaneSurface> plane = plane_through(below, above)) {
      face.surface = add_surface(*plane);
    } else {
      face.surface = add_surface(straight_wall(below, above));
      const double start = turned ? 1 : 0, end = 1 - start;
      trace(bottom, face.surface, line_in_domain(start, 0, end, 0));
      trace(top, face.surface, line_in_domain(start, 1, end, 1));
      trace(at_start, face.surface, line_in_domain(start, 0, start, 1));
      trace(at_end, face.surface, line_in_domain(end, 0, end, 1));
    }
    face.loop = {{bottom, false}, {at_end, false}, {top, true}, {at_start, true}};
    if (turned) turn(face.loop);
    if (outer) face.origin = wall_of_solid(below, above);
    return walls_[{number, low, high}] = add_face(std::move(face));
  }

  void trace(EdgeId edge, SurfaceId surface, NurbsCurve domain) {
    complex_.curves[static_cast<std::size_t>(complex_.edge(edge).curve.value)].traces.push_back(
        {surface, std::move(domain)});
  }

  /// Of straight edges with their ends in one plane; its x runs along the lower one.
  std::optional<PlaneSurface> plane_through(const NurbsCurve& below, const NurbsCurve& above) const {
    for (const NurbsCurve& curve : {below, above})
      if (curve.degree(0) != 1 || curve.size() != 2) return std::nullopt;
    const Eigen::Vector3d a = below.control_points().col(0), b = below.control_points().col(1);
    const Eigen::Vector3d x = (b - a).normalized();
    const Eigen::Vector3d up = above.control_points().col(0) - a;
    const Eigen::Vector3d y = (up - up.dot(x) * x).normalized();
    if (std::abs((above.control_points().col(1) - a).dot(x.cross(y))) > 1e-9 * solid_.size())
      return std::nullopt;
    return PlaneSurface{a, x, y};
  }

  /// The face of the solid on which all of a wall lies: the nearest, since others may be narrow and near.
  FaceId wall_of_solid(const NurbsCurve& below, const NurbsCurve& above) const {
    const auto point = [&](double u, double v) -> Eigen::Vector3d {
      const Eigen::Matrix<double, 1, 1> t(u);
      return (1 - v) * below.point(t) + v * above.point(t);
    };
    const Eigen::Vector3d middle = point(0.5, 0.5);
    const double tolerance = off_the_wall * solid_.size();
    std::optional<FaceId> best;
    double least = 1e300;
    for (const FaceId face : frame_.walls) {
      const geometry::FaceProjection nearest = solid_.project(face, middle);
      if (nearest.distance > tolerance || !solid_.contains(face, nearest.uv)) continue;
      double off = nearest.distance;
      for (const double u : {0.1, 0.3, 0.7, 0.9})
        for (const double v : {0.2, 0.8}) off = std::max(off, solid_.project(face, point(u, v)).distance);
      if (off < least) best = face, least = off;
    }
    if (!best)
      throw Error(ErrorCode::unsupported, fmt::format("no wall of the solid is at ({:.6g}, {:.6g}, {:.6g}) m",
                                                      middle.x(), middle.y(), middle.z()));
    if (least > tolerance)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} is not straight from floor to floor", describe(solid_, *best)));
    return *best;
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
  const MovingDrawing& moving_;
  const Layers& layers_;
  std::map<Upright, int> cells_at_;  // walls
  CellComplex complex_;
  std::map<Flat, VertexId> vertices_;
  std::map<Flat, EdgeId> level_edges_;
  std::map<Flat, FaceId> level_faces_;
  std::map<std::pair<int, bool>, SurfaceId> planes_;
  std::map<Upright, EdgeId> upright_edges_;
  std::map<Upright, FaceId> walls_;
};

}  // namespace

CellComplex column_complex(const Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                           const MovingDrawing& moving, const Layers& layers) {
  return ColumnComplex(solid, frame, quads, moving, layers).make();
}

}  // namespace isopatch::segmentation
