#include "segmentation/sweeps/internal/column_complex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/coons.hpp"
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

using Upright = Rounding::Upright;
using Flat = Rounding::Flat;

/// How far a straight wall may lie off the solid's, as a share of its size: what patches keep to as well.
/// Drafted walls of CAD programs are splines, and their edges run at paces of their own.
constexpr double off_the_wall = 1e-4;

/// Makes every vertex, edge and face once, by its number in the drawing and its levels.
class ColumnComplex {
 public:
  ColumnComplex(const Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                const MovingDrawing& moving, const Layers& layers, const Rounding& rounding)
      : solid_(solid), frame_(frame), quads_(quads), moving_(moving), layers_(layers), rounding_(rounding) {
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
    if (const auto same = rounding_.same_vertices.find({number, level});
        same != rounding_.same_vertices.end())
      return vertex(same->second.first, same->second.second);
    const auto [found, fresh] =
        vertices_.try_emplace({number, level}, static_cast<int>(complex_.vertices.size()));
    if (!fresh) return found->second;
    const auto moved = rounding_.vertices.find({number, level});
    complex_.vertices.push_back(moved == rounding_.vertices.end() ? moving_.place(number, height(level))
                                                                  : moved->second);
    return found->second;
  }

  EdgeId level_edge(int number, int level) {
    if (const auto same = rounding_.same_level_edges.find({number, level});
        same != rounding_.same_level_edges.end())
      return level_edge(same->second.first, same->second.second);
    const auto known = level_edges_.find({number, level});
    if (known != level_edges_.end()) return known->second;
    const VertexId from = vertex(drawn(number).start, level), to = vertex(drawn(number).end, level);
    return level_edges_[{number, level}] = complex_.add_edge({level_curve(number, level)}, from, to);
  }

  bool is_moved(int vertex, int level) const { return rounding_.vertices.contains({vertex, level}); }

  /// Chords go with their ends.
  NurbsCurve level_curve(int number, int level) {
    const auto rounded = rounding_.level_edges.find({number, level});
    if (rounded != rounding_.level_edges.end()) return rounded->second;
    NurbsCurve curve = moving_.curve(number, height(level));
    const int start = drawn(number).start, end = drawn(number).end;
    if (!is_moved(start, level) && !is_moved(end, level)) return curve;
    if (!is_segment(curve) && drawn(number).profile_edge >= 0)
      throw Error(ErrorCode::unsupported, "a round ends on a curved wall");
    Eigen::Matrix3Xd points = curve.control_points();
    points.col(0) = complex_.vertex(vertex(start, level));
    points.col(points.cols() - 1) = complex_.vertex(vertex(end, level));
    return NurbsCurve(curve.knots(), std::move(points), curve.weights());
  }

  /// As it is run through from low to high.
  EdgeUse upright_edge(int number, int low, int high) {
    if (const auto leaning = rounding_.leaning_edges.find({number, low, high});
        leaning != rounding_.leaning_edges.end())
      return {level_edge(leaning->second.flat.first, leaning->second.flat.second), leaning->second.reversed};
    const auto known = upright_edges_.find({number, low, high});
    if (known != upright_edges_.end()) return {known->second, false};
    const VertexId from = vertex(number, low), to = vertex(number, high);
    const auto rounded = rounding_.upright_edges.find({number, low, high});
    NurbsCurve shape = rounded == rounding_.upright_edges.end()
                           ? geometry::segment(complex_.vertex(from), complex_.vertex(to))
                           : rounded->second;
    const EdgeId made = complex_.add_edge({std::move(shape)}, from, to);
    upright_edges_[{number, low, high}] = made;
    return {made, false};
  }

  /// Of a quadrilateral in a level; looks up, or out of the solid.
  FaceId level_face(int quad, int level, std::optional<FaceId> origin, bool looks_up) {
    const auto known = level_faces_.find({quad, level});
    if (known != level_faces_.end()) return known->second;
    std::vector<EdgeUse> loop;
    bool is_level = true;
    for (const EdgeUse& side : quads_.quads[static_cast<std::size_t>(quad)].sides) {
      loop.push_back({level_edge(side.edge.value, level), side.reversed});
      is_level = is_level && !is_moved(drawn(side.edge.value).start, level) &&
                 !is_moved(drawn(side.edge.value).end, level);
    }
    if (!looks_up) turn(loop);
    const auto rounded = rounding_.floors.find({quad, level});
    FaceId made(0);
    if (rounded != rounding_.floors.end())
      made = add_rounded(rounded->second, std::move(loop));
    else if (is_level)
      made = complex_.add_face({plane_at(level, looks_up), std::move(loop), origin});
    else if (origin)
      throw Error(ErrorCode::unsupported, "a floor ends within the width of a round");
    else
      made = add_between(std::move(loop));
    return level_faces_[{quad, level}] = made;
  }

  SurfaceId plane_at(int level, bool looks_up) {
    const auto [surface, fresh] = planes_.try_emplace({level, looks_up}, SurfaceId(0));
    if (fresh) {
      const Eigen::Vector3d y = looks_up ? frame_.y : Eigen::Vector3d(-frame_.y);
      surface->second = complex_.add_surface(
          PlaneSurface{frame_.point(Eigen::Vector2d::Zero(), height(level)), frame_.x, y});
    }
    return surface->second;
  }

  /// As it is run through.
  NurbsCurve use_curve(const EdgeUse& use) const {
    const NurbsCurve& shape = std::get<NurbsCurve>(complex_.curve(complex_.edge(use.edge).curve).shape);
    return use.reversed ? reversed(shape, 0) : shape;
  }

  /// @param surface  over the unit square, whose sides from v = 0 on are the loop's
  FaceId add_on(geometry::NurbsSurface surface, std::vector<EdgeUse> loop, std::optional<FaceId> origin) {
    const SurfaceId made = complex_.add_surface(std::move(surface));
    const std::array<Eigen::Vector3d, 4> corners{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                                 Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0)};
    for (std::size_t k = 0; k < 4; ++k)
      complex_.add_trace(loop[k], made, geometry::segment(corners[k], corners[(k + 1) % 4]));
    return complex_.add_face({made, std::move(loop), origin});
  }

  /// Inside the solid, in no plane.
  FaceId add_between(std::vector<EdgeUse> loop) {
    geometry::NurbsSurface surface = geometry::coons_surface(
        {use_curve(loop[0]), use_curve(loop[1]), use_curve(loop[2]), use_curve(loop[3])});
    return add_on(std::move(surface), std::move(loop), {});
  }

  FaceId add_rounded(const Rounding::Side& side, std::vector<EdgeUse> loop) {
    const EdgeId first = level_edge(side.from.first, side.from.second);
    const auto at =
        std::find_if(loop.begin(), loop.end(), [&](const EdgeUse& use) { return use.edge == first; });
    std::rotate(loop.begin(), at, loop.end());
    const bool turned = loop.front().reversed;
    return add_on(turned ? reversed(side.surface, 0) : side.surface, std::move(loop), side.origin);
  }

  static EdgeUse back(EdgeUse use) { return {use.edge, !use.reversed}; }

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
    const EdgeUse at_start = upright_edge(drawn(number).start, low, high);
    const EdgeUse at_end = upright_edge(drawn(number).end, low, high);
    std::vector<EdgeUse> loop{{bottom, false}, at_end, {top, true}, back(at_start)};
    if (turned) loop = {{bottom, true}, at_start, {top, false}, back(at_end)};
    const auto rounded = rounding_.walls.find({number, low, high});
    FaceId made(0);
    if (rounded != rounding_.walls.end())
      made = add_rounded(rounded->second, std::move(loop));
    else
      made = add_wall(std::move(loop), outer);
    return walls_[{number, low, high}] = made;
  }

  /// @param loop  from its lower edge on
  FaceId add_wall(std::vector<EdgeUse> loop, bool outer) {
    const std::array<NurbsCurve, 4> sides{use_curve(loop[0]), use_curve(loop[1]), use_curve(loop[2]),
                                          use_curve(loop[3])};
    const NurbsCurve above = reversed(sides[2], 0);
    const bool ruled = is_segment(sides[1]) && is_segment(sides[3]);
    const std::optional<PlaneSurface> plane = plane_through(sides);
    if (outer && !plane && !ruled) throw Error(ErrorCode::unsupported, "a round ends on a curved wall");
    std::optional<FaceId> origin;
    if (outer) origin = wall_of_solid(sides[0], above);
    if (plane) return complex_.add_face({complex_.add_surface(*plane), std::move(loop), origin});
    return add_on(ruled ? straight_wall(sides[0], above) : geometry::coons_surface(sides), std::move(loop),
                  origin);
  }

  /// The plane of four curves, x along the first; nothing where they lie in none.
  std::optional<PlaneSurface> plane_through(const std::array<NurbsCurve, 4>& sides) const {
    const Eigen::Vector3d a = sides[0].control_points().col(0);
    const Eigen::Vector3d x = (sides[1].control_points().col(0) - a).normalized();
    const Eigen::Vector3d up = sides[3].control_points().col(0) - a;
    const Eigen::Vector3d y = (up - up.dot(x) * x).normalized();
    for (const NurbsCurve& side : sides)
      if (((side.control_points().colwise() - a).transpose() * x.cross(y)).cwiseAbs().maxCoeff() >
          1e-9 * solid_.size())
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
    // Two cells, one above the other, share a face: it is the lower cell's top and looks up.
    add(level_face(quad, layer.low, layer.bottom, !layer.bottom), !layer.bottom);
    add(level_face(quad, layer.high, layer.top, true), false);
    for (const EdgeUse& side : quads_.quads[static_cast<std::size_t>(quad)].sides) {
      if (const auto leaning = rounding_.leaning_walls.find({side.edge.value, layer.low, layer.high});
          leaning != rounding_.leaning_walls.end()) {
        add(level_face(leaning->second.flat.first, leaning->second.flat.second, {}, true),
            leaning->second.reversed);
        continue;
      }
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
  const Rounding& rounding_;
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
                           const MovingDrawing& moving, const Layers& layers, const Rounding& rounding) {
  return ColumnComplex(solid, frame, quads, moving, layers, rounding).make();
}

}  // namespace isopatch::segmentation
