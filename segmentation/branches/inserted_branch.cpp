#include "segmentation/branches/internal/inserted_branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/branches/internal/branch_levels.hpp"
#include "segmentation/branches/internal/column.hpp"
#include "segmentation/branches/internal/layer_shape.hpp"
#include "segmentation/branches/internal/plan_drawing.hpp"
#include "segmentation/sweeps/interpolate.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CurveId;
using geometry::EdgeUse;
using geometry::NurbsCurve;
using geometry::Parameter;
using geometry::PlaneSurface;
using geometry::SurfaceId;

class Insertion {
 public:
  Insertion(const Brep& solid, const CellComplex& body, const Branch& branch, const BranchPlace& place,
            FaceId cut_face)
      : solid_(solid),
        view_(branch.view),
        cut_face_(cut_face),
        has_cut_top_(!place.on_top.empty()),
        column_(column_below(body, view_, place.corners, 1e-6 * solid.size())),
        levels_(solid, body, branch, place, column_, 1e-6 * solid.size()),
        drawing_(levels_.drawing()),
        complex_(body) {}

  CellComplex make() {
    take_out();
    for (std::size_t q = 0; q < drawing_.quads.quads.size(); ++q)
      for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
        if (levels_.has_material(static_cast<int>(q), l)) add_cell(static_cast<int>(q), l);
    return std::move(complex_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const QuadEdge& drawn(int edge) const { return drawing_.quads.edges[index(edge)]; }
  /// The complex without the column's cells and the faces between them.
  void take_out() {
    std::set<FaceId> gone;
    for (const ColumnLayer& layer : column_.layers) gone.insert(layer.face);
    const std::set<geometry::CellId> cells(column_.cells.begin(), column_.cells.end());
    std::vector<FaceId> renamed;
    std::vector<geometry::CellFace> faces;
    for (int f = 0; f < static_cast<int>(complex_.faces.size()); ++f) {
      renamed.emplace_back(static_cast<int>(faces.size()));
      if (!gone.contains(FaceId(f))) faces.push_back(complex_.faces[index(f)]);
    }
    std::vector<geometry::Cell> left;
    for (int c = 0; c < static_cast<int>(complex_.cells.size()); ++c) {
      if (cells.contains(geometry::CellId(c))) continue;
      left.push_back(complex_.cells[index(c)]);
      for (geometry::CellFaceUse& use : left.back().faces) use.face = renamed[index(use.face.value)];
    }
    for (auto& walls : column_.walls)
      for (geometry::CellFaceUse& use : walls) use.face = renamed[index(use.face.value)];
    complex_.faces = std::move(faces);
    complex_.cells = std::move(left);
  }

  // What is new, each made once.

  bool is_side(int edge) const { return drawn(edge).profile_edge >= 0 && drawn(edge).profile_edge < 4; }

  VertexId vertex(int node, std::size_t level) {
    if (node < 4) return column_.layers[index(levels_[level].layer)].corners[index(node)];
    const auto [found, fresh] =
        vertices_.try_emplace({node, level}, VertexId(static_cast<int>(complex_.vertices.size())));
    if (fresh) {
      const Eigen::Vector2d plan = levels_.plan_of(node, level);
      complex_.vertices.push_back(view_.point(plan, levels_.height(level, plan, levels_.is_on_floor(node))));
    }
    return found->second;
  }

  NurbsCurve shape(EdgeUse use) const {
    const auto& made = std::get<NurbsCurve>(complex_.curve(complex_.edge(use.edge).curve).shape);
    return use.reversed ? reversed(made, 0) : made;
  }

  /// As it is drawn.
  EdgeUse edge(int number, std::size_t level) {
    if (is_side(number)) {
      const auto side = index(drawn(number).profile_edge);
      const EdgeUse use = column_.layers[index(levels_[level].layer)].sides[side];
      const bool along = drawn(number).start == drawn(number).profile_edge;
      return {use.edge, use.reversed == along};
    }
    const auto known = edges_.find({number, level});
    if (known != edges_.end()) return {known->second, false};
    const VertexId from = vertex(drawn(number).start, level), to = vertex(drawn(number).end, level);
    return {edges_[{number, level}] = complex_.add_edge({level_curve(number, level)}, from, to), false};
  }

  NurbsCurve level_curve(int number, std::size_t level) {
    const BranchLevel& at = levels_[level];
    const NurbsCurve plan = levels_.plan_curve(number, level);
    if (at.flat) {
      const bool from = levels_.is_on_floor(drawn(number).start), to = levels_.is_on_floor(drawn(number).end);
      if (!at.shape || (from && to)) {
        Eigen::Matrix3Xd points = plan.control_points();
        for (Eigen::Index i = 0; i < points.cols(); ++i)
          points.col(i) = view_.point(points.col(i).head<2>(), *at.flat);
        return NurbsCurve(plan.knots(), points, plan.weights());
      }
      if (from || to)
        return geometry::segment(complex_.vertex(vertex(drawn(number).start, level)),
                                 complex_.vertex(vertex(drawn(number).end, level)));
    }
    return at.shape->lifted(plan);
  }

  /// From a level's lower neighbour up to it.
  EdgeUse upright(int node, std::size_t level) {
    if (node < 4) return column_.uprights[index(levels_[level].layer)][index(node)];
    const auto known = uprights_.find({node, level});
    if (known != uprights_.end()) return {known->second, false};
    const VertexId low = vertex(node, level + 1), high = vertex(node, level);
    const EdgeId made = complex_.add_straight_edge(low, high);
    return {uprights_[{node, level}] = made, false};
  }

  static void turn(std::vector<EdgeUse>& loop) {
    std::reverse(loop.begin(), loop.end());
    for (EdgeUse& use : loop) use.reversed = !use.reversed;
  }

  /// The face of the solid that a place is on.
  FaceId origin_at(const Eigen::Vector3d& place) const {
    std::optional<FaceId> best;
    double least = 1e-4 * solid_.size();
    for (int f = 0; f < static_cast<int>(solid_.faces().size()); ++f) {
      const geometry::FaceProjection nearest = solid_.project(FaceId(f), place);
      if (nearest.distance >= least || !solid_.contains(FaceId(f), nearest.uv)) continue;
      best = FaceId(f);
      least = nearest.distance;
    }
    if (!best)
      throw Error(ErrorCode::unsupported, fmt::format("no face of the solid is at ({:.6g}, {:.6g}, {:.6g}) m",
                                                      place.x(), place.y(), place.z()));
    return *best;
  }

  /// Of a quadrilateral at a level, seen along the view.
  Eigen::Vector2d middle_of(int quad, std::size_t level) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const EdgeUse& side : drawing_.quads.quads[index(quad)].sides) {
      const NurbsCurve curve = shape(edge(side.edge.value, level));
      const auto at = [&](double t) { return view_.flat(curve.point(Parameter<1>(t))); };
      sum += at(0.5) / 2 - (at(0) + at(1)) / 8;
    }
    return sum;
  }

  /// Looks up, or out of the solid.
  FaceId level_face(int quad, std::size_t level) {
    const auto known = level_faces_.find({quad, level});
    if (known != level_faces_.end()) return known->second;
    const bool above = level > 0 && levels_.has_material(quad, level - 1);
    const bool below = level + 1 < levels_.size() && levels_.has_material(quad, level);
    const bool looks_up = below;
    const BranchLevel& at = levels_[level];
    const bool on_floor = at.flat && levels_.is_inside(quad);
    std::vector<EdgeUse> loop;
    for (const EdgeUse& side : drawing_.quads.quads[index(quad)].sides) {
      const EdgeUse use = edge(side.edge.value, level);
      loop.push_back({use.edge, use.reversed != side.reversed});
    }
    geometry::CellFace face{level_surface(loop, at, on_floor, looks_up), loop, {}};
    if (!looks_up) turn(face.loop);
    if (above != below) {
      const Eigen::Vector2d middle = middle_of(quad, level);
      face.origin = level == 0 && has_cut_top_
                        ? cut_face_
                        : origin_at(view_.point(middle, levels_.height(level, middle, on_floor)));
    }
    return level_faces_[{quad, level}] = complex_.add_face(std::move(face));
  }

  SurfaceId level_surface(const std::vector<EdgeUse>& loop, const BranchLevel& at, bool on_floor,
                          bool looks_up) {
    if (on_floor || at.shape->is_flat()) {
      const double height = on_floor ? *at.flat : at.shape->height({0, 0});
      return complex_.add_surface(
          PlaneSurface{view_.point({0, 0}, height), view_.x, looks_up ? view_.y : -view_.y});
    }
    if (at.flat) return blended(loop);
    const SurfaceId made =
        complex_.add_surface(looks_up ? at.shape->surface() : reversed(at.shape->surface(), 1));
    for (const EdgeUse& use : loop) {
      const NurbsCurve domain = at.shape->trace(shape({use.edge, false}));
      complex_.add_trace({use.edge, false}, made, looks_up ? domain : mirrored(domain));
    }
    return made;
  }

  /// v to 1 - v.
  static NurbsCurve mirrored(const NurbsCurve& domain) {
    Eigen::Matrix3Xd points = domain.control_points();
    points.row(1) = 1 - points.row(1).array();
    return NurbsCurve(domain.knots(), points, domain.weights());
  }

  /// A Coons patch between four edges, inside the body: looks as its loop runs.
  SurfaceId blended(const std::vector<EdgeUse>& loop) {
    const std::array<NurbsCurve, 4> sides = {shape(loop[0]), shape(loop[1]), shape(loop[2]), shape(loop[3])};
    const auto at = [&](std::size_t side, double t) { return sides[side].point(Parameter<1>(t)); };
    const SurfaceId made = complex_.add_surface(interpolated([&](double u, double v) -> Eigen::Vector3d {
      const Eigen::Vector3d corners =
          (1 - u) * (1 - v) * at(0, 0) + u * (1 - v) * at(1, 0) + u * v * at(2, 0) + (1 - u) * v * at(3, 0);
      return (1 - v) * at(0, u) + v * at(2, 1 - u) + (1 - u) * at(3, 1 - v) + u * at(1, v) - corners;
    }));
    trace_sides(loop, made);
    return made;
  }

  /// Of a loop around the unit square.
  void trace_sides(const std::vector<EdgeUse>& loop, SurfaceId surface) {
    const std::array<Eigen::Vector3d, 4> corners = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                                    Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0)};
    for (std::size_t i = 0; i < 4; ++i)
      complex_.add_trace(loop[i], surface, geometry::segment(corners[i], corners[(i + 1) % 4]));
  }

  /// Below a level, over an edge of the drawing: looks to its right, or out of the solid.
  geometry::CellFaceUse wall(EdgeUse side, std::size_t level, bool is_outer) {
    const int number = side.edge.value;
    if (is_side(number)) return column_.walls[index(levels_[level].layer)][index(drawn(number).profile_edge)];
    const auto known = walls_made_.find({number, level});
    if (known != walls_made_.end()) return {known->second, side.reversed, 0};
    const bool turned = is_outer && side.reversed;
    const EdgeUse low = edge(number, level + 1), high = edge(number, level);
    std::vector<EdgeUse> loop = {{low.edge, low.reversed != turned},
                                 upright(turned ? drawn(number).start : drawn(number).end, level),
                                 {high.edge, high.reversed == turned},
                                 upright(turned ? drawn(number).end : drawn(number).start, level)};
    loop[3].reversed = !loop[3].reversed;
    const NurbsCurve below = shape(loop[0]), above = shape({loop[2].edge, !loop[2].reversed});
    geometry::CellFace face{SurfaceId(0), loop, {}};
    if (const auto plane = plane_through(below, above)) {
      face.surface = complex_.add_surface(*plane);
    } else {
      face.surface = complex_.add_surface(geometry::ruled(below, above));
      trace_sides(loop, face.surface);
    }
    if (is_outer)
      face.origin = origin_at((below.point(Parameter<1>(0.5)) + above.point(Parameter<1>(0.5))) / 2);
    const FaceId made = complex_.add_face(std::move(face));
    return {walls_made_[{number, level}] = made, !is_outer && side.reversed, 0};
  }

  /// Of straight edges in one plane.
  std::optional<PlaneSurface> plane_through(const NurbsCurve& below, const NurbsCurve& above) const {
    for (const NurbsCurve& curve : {below, above})
      if (curve.degree(0) != 1 || curve.size() != 2) return std::nullopt;
    const Eigen::Vector3d a = below.control_points().col(0), b = below.control_points().col(1);
    const Eigen::Vector3d x = (b - a).normalized(), up = above.control_points().col(0) - a;
    const Eigen::Vector3d y = (up - up.dot(x) * x).normalized();
    if (std::abs((above.control_points().col(1) - a).dot(x.cross(y))) > 1e-9 * solid_.size())
      return std::nullopt;
    return PlaneSurface{a, x, y};
  }

  bool has_neighbour(int quad, EdgeUse side, std::size_t level) const {
    for (std::size_t q = 0; q < drawing_.quads.quads.size(); ++q)
      if (static_cast<int>(q) != quad && levels_.has_material(static_cast<int>(q), level))
        for (const EdgeUse& other : drawing_.quads.quads[q].sides)
          if (other.edge == side.edge) return true;
    return false;
  }

  void add_cell(int quad, std::size_t level) {
    geometry::Cell cell;
    const auto add = [&](geometry::CellFaceUse use) {
      use.side = static_cast<int>(cell.faces.size());
      cell.faces.push_back(use);
    };
    add({level_face(quad, level), false, 0});
    // The one below looks up into this cell unless it looks out.
    const bool below_is_free = level + 2 >= levels_.size() || !levels_.has_material(quad, level + 1);
    add({level_face(quad, level + 1), !below_is_free, 0});
    for (const EdgeUse& side : drawing_.quads.quads[index(quad)].sides)
      add(wall(side, level, !is_side(side.edge.value) && !has_neighbour(quad, side, level)));
    complex_.cells.push_back(std::move(cell));
  }

  using OnLevel = std::pair<int, std::size_t>;  // something of the drawing, and a level
  const Brep& solid_;
  const PlanView& view_;
  FaceId cut_face_;
  bool has_cut_top_;
  Column column_;
  BranchLevels levels_;
  const PlanDrawing& drawing_;
  CellComplex complex_;
  std::map<OnLevel, VertexId> vertices_;
  std::map<OnLevel, EdgeId> edges_, uprights_;
  std::map<OnLevel, FaceId> level_faces_, walls_made_;
};

}  // namespace

CellComplex inserted_branch(const Brep& solid, const CellComplex& body, const Branch& branch,
                            const BranchPlace& place, FaceId cut_face) {
  return Insertion(solid, body, branch, place, cut_face).make();
}

}  // namespace isopatch::segmentation
