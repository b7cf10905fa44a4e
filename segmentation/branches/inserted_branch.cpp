#include "segmentation/branches/internal/inserted_branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
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

/// Of a layer's half width, beside what is as it is drawn: less would fold hexahedra.
constexpr double least_left = 0.02;

/// A layer of the column, or the top of the branch.
struct Level {
  std::optional<LayerShape> shape;         // nothing of the top
  std::optional<double> flat;              // height of the top, or of a floor inside its outlines
  int layer = -1;                          // of the column
  double kept = 0;                         // half width that is as it is drawn
  std::array<double, 2> stretch = {1, 1};  // what becomes of the rest, below it and above
};

class Insertion {
 public:
  Insertion(const Brep& solid, const CellComplex& body, const Branch& branch, const BranchPlace& place,
            FaceId cut_face)
      : solid_(solid),
        branch_(branch),
        view_(branch.view),
        place_(place),
        cut_face_(cut_face),
        tolerance_(1e-6 * solid.size()),
        column_(column_below(body, view_, place.corners, tolerance_)),
        complex_(body) {}

  CellComplex make() {
    find_levels();
    draw();
    find_nodes();
    for (std::size_t l = 0; l < levels_.size(); ++l) find_stretch(l);
    take_out();
    for (std::size_t q = 0; q < drawing_.quads.quads.size(); ++q)
      for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
        if (has_material(static_cast<int>(q), l)) add_cell(static_cast<int>(q), l);
    return std::move(complex_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const QuadEdge& drawn(int edge) const { return drawing_.quads.edges[index(edge)]; }
  const Outline& outline(int o) const { return branch_.outlines[index(o)]; }
  int outline_count() const { return static_cast<int>(branch_.outlines.size()); }

  void find_levels() {
    if (place_.top) levels_.push_back({{}, place_.top, -1});
    for (std::size_t l = 0; l < column_.layers.size(); ++l)
      levels_.push_back(
          {LayerShape(complex_, view_, column_.layers[l], tolerance_), {}, static_cast<int>(l)});
    for (std::size_t f = 0; f < place_.floor_radii.size(); ++f) {
      const auto level = std::find_if(levels_.begin(), levels_.end(), [&](const Level& candidate) {
        const auto radius = candidate.shape ? candidate.shape->radius() : std::nullopt;
        return radius && std::abs(*radius - place_.floor_radii[f]) < tolerance_;
      });
      if (level == levels_.end())
        throw Error(ErrorCode::unsupported, "the body cannot be divided at the floor of a branch");
      level->flat = branch_.floors[f];
    }
  }

  std::size_t first_layer() const { return place_.top ? 1 : 0; }

  /// Height of the body's layer, or of a floor where one is asked for.
  double height(std::size_t level, const Eigen::Vector2d& plan, bool on_floor) const {
    const Level& at = levels_[level];
    return on_floor && at.flat ? *at.flat : at.shape->height(plan);
  }

  /// Whether a wall of an outline is beside what lies between two levels.
  bool has_wall(int o, std::size_t level) const {
    const auto key = std::pair(o, level);
    if (const auto known = walls_.find(key); known != walls_.end()) return known->second;
    const Eigen::Vector2d plan = outline(o).curves.front().point(0.37);
    const double middle = (height(level, plan, true) + height(level + 1, plan, true)) / 2;
    const Eigen::Vector3d place = view_.point(plan, middle);
    const bool result = std::any_of(outline(o).walls.begin(), outline(o).walls.end(), [&](FaceId face) {
      const geometry::FaceProjection nearest = solid_.project(face, place);
      return nearest.distance < tolerance_ && solid_.contains(face, nearest.uv);
    });
    return walls_[key] = result;
  }

  /// Whether an outline's walls begin, end or pass at a level.
  bool is_real(int o, std::size_t level) const {
    return (level > 0 && has_wall(o, level - 1)) || (level + 1 < levels_.size() && has_wall(o, level));
  }

  /// Just inside an outline (-1: outside of all) and below a level.
  bool has_material_in(int o, std::size_t level) const {
    bool stands_out = level >= first_layer();
    for (int around = o; around >= 0; around = parent_[index(around)]) {
      if (!has_wall(around, level)) continue;
      if (outline(around).is_void) return false;
      stands_out = true;
    }
    return stands_out;
  }

  bool has_material(int quad, std::size_t level) const {
    return has_material_in(drawing_.around[index(drawing_.quads.quads[index(quad)].region)], level);
  }

  std::array<Eigen::Vector2d, 4> corners_at(std::size_t level) const {
    std::array<Eigen::Vector2d, 4> result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = view_.flat(complex_.vertex(column_.layers[index(levels_[level].layer)].corners[i]));
    return result;
  }

  static double area(const std::array<Eigen::Vector2d, 4>& corners) {
    const Eigen::Vector2d a = corners[2] - corners[0], b = corners[3] - corners[1];
    return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
  }

  /// In the narrowest layer that has all outlines that any layer has.
  void draw() {
    std::set<int> everywhere;
    for (std::size_t l = first_layer(); l < levels_.size(); ++l)
      for (int o = 0; o < outline_count(); ++o)
        if (is_real(o, l)) everywhere.insert(o);
    std::optional<std::size_t> best;
    for (std::size_t l = first_layer(); l < levels_.size(); ++l) {
      const bool all =
          std::all_of(everywhere.begin(), everywhere.end(), [&](int o) { return is_real(o, l); });
      if (all && (!best || area(corners_at(l)) < (1 - 1e-9) * area(corners_at(*best)))) best = l;
    }
    reference_ = corners_at(best.value_or(first_layer()));
    parent_ = nesting(branch_.outlines);
    std::vector<bool> wanted;
    for (int o = 0; o < outline_count(); ++o) {
      bool any = false;
      for (std::size_t l = 0; l + 1 < levels_.size(); ++l) any = any || has_material_in(o, l);
      wanted.push_back(any);
    }
    drawing_ = plan_drawing(reference_, branch_.outlines, wanted, place_.on_top);
  }

  void find_nodes() {
    nodes_.assign(drawing_.quads.vertices.begin(), drawing_.quads.vertices.end());
    node_outline_.assign(nodes_.size(), -1);
    for (std::size_t e = 0; e < drawing_.quads.edges.size(); ++e) {
      const QuadEdge& edge = drawing_.quads.edges[e];
      if (edge.profile_edge < 4) continue;
      const NurbsCurve curve = drawing_.curve(static_cast<int>(e));
      for (const auto& [node, t] : {std::pair(edge.start, 0.0), std::pair(edge.end, 1.0)}) {
        nodes_[index(node)] = curve.point(Parameter<1>(t)).head<2>();
        if (const int on = drawing_.outline_of[index(edge.profile_edge)]; on >= 0)
          node_outline_[index(node)] = on;
      }
    }
  }

  /// Walls that a layer has stay where they are; beside them the drawing is squeezed or stretched across the
  /// axis, so that its sides are the layer's.
  void find_stretch(std::size_t l) {
    Level& level = levels_[l];
    if (!level.shape) return;
    for (int o = 0; o < outline_count(); ++o)
      if (is_real(o, l)) level.kept = std::max(level.kept, half_width(outline(o)));
    const std::array<double, 2> drawn = half_widths(reference_), here = half_widths(corners_at(l));
    for (const std::size_t side : {0U, 1U}) {
      level.stretch[side] = (here[side] - level.kept) / (drawn[side] - level.kept);
      if (!(level.kept < (1 - least_left) * std::min(drawn[side], here[side])))
        throw Error(
            ErrorCode::unsupported,
            fmt::format("{} leaves no room in a layer of its body that reaches {:.3g} m to a side of it",
                        describe(solid_, outline(0).walls.front()), here[side]));
    }
  }

  static double half_width(const Outline& outline) {
    double result = 0;
    for (const PlanCurve& curve : outline.curves)
      for (int i = 0; i <= 64; ++i) result = std::max(result, std::abs(curve.point(i / 64.0).y()));
    return result;
  }

  /// Of corners, below the branch and above it.
  static std::array<double, 2> half_widths(const std::array<Eigen::Vector2d, 4>& corners) {
    std::array<double, 2> sum = {0, 0};
    for (const Eigen::Vector2d& corner : corners) sum[corner.y() < 0 ? 0 : 1] += std::abs(corner.y());
    return {sum[0] / 2, sum[1] / 2};
  }

  /// Where a place of the drawing is at a level.
  Eigen::Vector2d at_level(const Eigen::Vector2d& plan, std::size_t l) const {
    const Level& level = levels_[l];
    const double beyond = std::abs(plan.y()) - level.kept;
    if (!level.shape || beyond < 0) return plan;
    return {plan.x(), std::copysign(level.kept + level.stretch[plan.y() < 0 ? 0 : 1] * beyond, plan.y())};
  }

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

  Eigen::Vector2d plan_of(int node, std::size_t level) const { return at_level(nodes_[index(node)], level); }

  /// Whether something of the drawing lies on a floor where a level has one.
  bool is_on_floor(int node) const {
    if (inside_.empty()) {
      inside_.assign(nodes_.size(), false);
      for (const Quad& quad : drawing_.quads.quads)
        if (drawing_.around[index(quad.region)] >= 0)
          for (const EdgeUse& side : quad.sides)
            inside_[index(drawn(side.edge.value).start)] = inside_[index(drawn(side.edge.value).end)] = true;
      for (std::size_t n = 0; n < nodes_.size(); ++n) inside_[n] = inside_[n] || node_outline_[n] >= 0;
    }
    return inside_[index(node)];
  }

  bool is_side(int edge) const { return drawn(edge).profile_edge >= 0 && drawn(edge).profile_edge < 4; }

  VertexId vertex(int node, std::size_t level) {
    if (node < 4) return column_.layers[index(levels_[level].layer)].corners[index(node)];
    const auto [found, fresh] =
        vertices_.try_emplace({node, level}, VertexId(static_cast<int>(complex_.vertices.size())));
    if (fresh) {
      const Eigen::Vector2d plan = plan_of(node, level);
      complex_.vertices.push_back(view_.point(plan, height(level, plan, is_on_floor(node))));
    }
    return found->second;
  }

  EdgeId add_edge(NurbsCurve shape, VertexId from, VertexId to) {
    complex_.curves.push_back({std::move(shape)});
    complex_.edges.push_back({CurveId(static_cast<int>(complex_.curves.size()) - 1), 0, 1, from, to});
    return EdgeId(static_cast<int>(complex_.edges.size()) - 1);
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
    return {edges_[{number, level}] = add_edge(level_curve(number, level), from, to), false};
  }

  /// Where an edge of the drawing is at a level, seen along the view.
  NurbsCurve plan_curve(int number, std::size_t level) const {
    NurbsCurve plan = drawing_.curve(number);
    double widest = 0;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
      widest = std::max(widest, std::abs(plan.point(Parameter<1>(t)).y()));
    if (widest <= levels_[level].kept + tolerance_) return plan;
    Eigen::Matrix3Xd points = plan.control_points();
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      points.col(i).head<2>() = at_level(points.col(i).head<2>(), level);
    return NurbsCurve(plan.knots(), points, plan.weights());
  }

  NurbsCurve level_curve(int number, std::size_t level) {
    const Level& at = levels_[level];
    const NurbsCurve plan = plan_curve(number, level);
    if (at.flat) {
      const bool from = is_on_floor(drawn(number).start), to = is_on_floor(drawn(number).end);
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
    const EdgeId made = add_edge(geometry::segment(complex_.vertex(low), complex_.vertex(high)), low, high);
    return {uprights_[{node, level}] = made, false};
  }

  SurfaceId add_surface(geometry::CellSurface surface) {
    complex_.surfaces.push_back(std::move(surface));
    return SurfaceId(static_cast<int>(complex_.surfaces.size()) - 1);
  }

  void trace(EdgeUse use, SurfaceId surface, NurbsCurve domain) {
    complex_.curves[index(complex_.edge(use.edge).curve.value)].traces.push_back(
        {surface, use.reversed ? reversed(domain, 0) : std::move(domain)});
  }

  static void turn(std::vector<EdgeUse>& loop) {
    std::reverse(loop.begin(), loop.end());
    for (EdgeUse& use : loop) use.reversed = !use.reversed;
  }

  FaceId add_face(geometry::CellFace face) {
    complex_.faces.push_back(std::move(face));
    return FaceId(static_cast<int>(complex_.faces.size()) - 1);
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
    const bool above = level > 0 && has_material(quad, level - 1);
    const bool below = level + 1 < levels_.size() && has_material(quad, level);
    const bool looks_up = below;
    const Level& at = levels_[level];
    const bool on_floor = at.flat && drawing_.around[index(drawing_.quads.quads[index(quad)].region)] >= 0;
    std::vector<EdgeUse> loop;
    for (const EdgeUse& side : drawing_.quads.quads[index(quad)].sides) {
      const EdgeUse use = edge(side.edge.value, level);
      loop.push_back({use.edge, use.reversed != side.reversed});
    }
    geometry::CellFace face{level_surface(loop, at, on_floor, looks_up), loop, {}};
    if (!looks_up) turn(face.loop);
    if (above != below) {
      const Eigen::Vector2d middle = middle_of(quad, level);
      face.origin = level == 0 && !place_.on_top.empty()
                        ? cut_face_
                        : origin_at(view_.point(middle, height(level, middle, on_floor)));
    }
    return level_faces_[{quad, level}] = add_face(std::move(face));
  }

  SurfaceId level_surface(const std::vector<EdgeUse>& loop, const Level& at, bool on_floor, bool looks_up) {
    if (on_floor || at.shape->is_flat()) {
      const double height = on_floor ? *at.flat : at.shape->height({0, 0});
      return add_surface(PlaneSurface{view_.point({0, 0}, height), view_.x, looks_up ? view_.y : -view_.y});
    }
    if (at.flat) return blended(loop);
    const SurfaceId made = add_surface(looks_up ? at.shape->surface() : reversed(at.shape->surface(), 1));
    for (const EdgeUse& use : loop) {
      const NurbsCurve domain = at.shape->trace(shape({use.edge, false}));
      trace({use.edge, false}, made, looks_up ? domain : mirrored(domain));
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
    const SurfaceId made = add_surface(interpolated([&](double u, double v) -> Eigen::Vector3d {
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
      trace(loop[i], surface, geometry::segment(corners[i], corners[(i + 1) % 4]));
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
      face.surface = add_surface(*plane);
    } else {
      face.surface = add_surface(geometry::ruled(below, above));
      trace_sides(loop, face.surface);
    }
    if (is_outer)
      face.origin = origin_at((below.point(Parameter<1>(0.5)) + above.point(Parameter<1>(0.5))) / 2);
    const FaceId made = add_face(std::move(face));
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
      if (static_cast<int>(q) != quad && has_material(static_cast<int>(q), level))
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
    const bool below_is_free = level + 2 >= levels_.size() || !has_material(quad, level + 1);
    add({level_face(quad, level + 1), !below_is_free, 0});
    for (const EdgeUse& side : drawing_.quads.quads[index(quad)].sides)
      add(wall(side, level, !is_side(side.edge.value) && !has_neighbour(quad, side, level)));
    complex_.cells.push_back(std::move(cell));
  }

  using OnLevel = std::pair<int, std::size_t>;  // something of the drawing, and a level
  const Brep& solid_;
  const Branch& branch_;
  const PlanView& view_;
  const BranchPlace& place_;
  FaceId cut_face_;
  double tolerance_;
  Column column_;
  CellComplex complex_;
  std::vector<Level> levels_;
  std::array<Eigen::Vector2d, 4> reference_;
  std::vector<int> parent_;
  PlanDrawing drawing_;
  std::vector<Eigen::Vector2d> nodes_;
  std::vector<int> node_outline_;
  mutable std::vector<bool> inside_;
  mutable std::map<std::pair<int, std::size_t>, bool> walls_;
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
