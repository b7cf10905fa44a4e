#include "segmentation/branches/internal/branch_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;
using geometry::Parameter;

/// Least room beside a branch for what is squeezed or stretched, as a share of half its layer's width: less
/// would fold hexahedra.
constexpr double least_left = 0.02;

std::size_t number(int i) {
  return static_cast<std::size_t>(i);
}

double area(const std::array<Eigen::Vector2d, 4>& corners) {
  const Eigen::Vector2d a = corners[2] - corners[0], b = corners[3] - corners[1];
  return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
}

Eigen::Vector3d in_plane(const Eigen::Vector2d& plan) {
  return {plan.x(), plan.y(), 0};
}

/// Along x and y.
Eigen::Vector2d half_width(const Outline& outline, const Eigen::Vector2d& middle) {
  Eigen::Vector2d result(0, 0);
  for (const PlanCurve& curve : outline.curves)
    for (int i = 0; i <= 64; ++i) result = result.cwiseMax((curve.point(i / 64.0) - middle).cwiseAbs());
  return result;
}

/// Half the width of a quadrilateral along an axis, on the low and the high side of its middle.
std::array<double, 2> half_widths(const std::array<Eigen::Vector2d, 4>& corners,
                                  const Eigen::Vector2d& middle, Eigen::Index axis) {
  std::array<double, 2> sum = {0, 0};
  for (const Eigen::Vector2d& corner : corners) {
    const double way = corner[axis] - middle[axis];
    sum[way < 0 ? 0 : 1] += std::abs(way) / 2;
  }
  return sum;
}

}  // namespace

BranchLevels::BranchLevels(const geometry::Brep& solid, const geometry::CellComplex& body,
                           const Branch& branch, const BranchPlace& place, const Column& column,
                           double tolerance)
    : solid_(solid),
      branch_(branch),
      place_(place),
      tolerance_(tolerance),
      middle_((branch.low + branch.high) / 2, 0) {
  find_levels(body, column);
  draw();
  find_nodes();
  find_floor();
  for (std::size_t l = 0; l < levels_.size(); ++l) find_stretch(l);
}

void BranchLevels::find_levels(const geometry::CellComplex& body, const Column& column) {
  const PlanView& view = branch_.view;
  if (place_.top) levels_.push_back({{}, place_.top, -1, {}});
  for (std::size_t l = 0; l < column.layers.size(); ++l) {
    BranchLevel level{LayerShape(body, view, column.layers[l], tolerance_), {}, static_cast<int>(l), {}};
    for (std::size_t i = 0; i < 4; ++i)
      level.corners[i] = view.flat(body.vertex(column.layers[l].corners[i]));
    levels_.push_back(std::move(level));
  }
  for (std::size_t f = 0; f < place_.floor_radii.size(); ++f) {
    const auto level = std::find_if(levels_.begin(), levels_.end(), [&](const BranchLevel& candidate) {
      const auto radius = candidate.shape ? candidate.shape->radius() : std::nullopt;
      return radius && std::abs(*radius - place_.floor_radii[f]) < tolerance_;
    });
    if (level == levels_.end())
      throw Error(ErrorCode::unsupported, "the body cannot be divided at the floor of a branch");
    level->flat = branch_.floors[f];
  }
}

double BranchLevels::height(std::size_t level, const Eigen::Vector2d& plan, bool on_floor) const {
  const BranchLevel& at = levels_[level];
  return on_floor && at.flat ? *at.flat : at.shape->height(plan);
}

/// Whether a wall of an outline is beside what lies between two levels.
bool BranchLevels::has_wall(int o, std::size_t level) const {
  const auto key = std::pair(o, level);
  if (const auto known = walls_.find(key); known != walls_.end()) return known->second;
  const Eigen::Vector2d plan = outline(o).curves.front().point(0.37);
  const double middle = (height(level, plan, true) + height(level + 1, plan, true)) / 2;
  const Eigen::Vector3d place = branch_.view.point(plan, middle);
  const bool result = std::any_of(outline(o).walls.begin(), outline(o).walls.end(), [&](FaceId face) {
    const geometry::FaceProjection nearest = solid_.project(face, place);
    return nearest.distance < tolerance_ && solid_.contains(face, nearest.uv);
  });
  return walls_[key] = result;
}

/// Whether an outline's walls begin, end or pass at a level.
bool BranchLevels::is_real(int o, std::size_t level) const {
  return (level > 0 && has_wall(o, level - 1)) || (level + 1 < levels_.size() && has_wall(o, level));
}

/// Just inside an outline (-1: outside of all) and below a level.
bool BranchLevels::has_material_in(int o, std::size_t level) const {
  bool stands_out = level >= first_layer();
  for (int around = o; around >= 0; around = parent_[number(around)]) {
    if (!has_wall(around, level)) continue;
    if (outline(around).is_void) return false;
    stands_out = true;
  }
  return stands_out;
}

bool BranchLevels::has_material(int quad, std::size_t level) const {
  return has_material_in(around(quad), level);
}

/// In the narrowest layer that has all outlines that any layer has.
void BranchLevels::draw() {
  std::set<int> everywhere;
  for (std::size_t l = first_layer(); l < levels_.size(); ++l)
    for (int o = 0; o < outline_count(); ++o)
      if (is_real(o, l)) everywhere.insert(o);
  std::optional<std::size_t> best;
  for (std::size_t l = first_layer(); l < levels_.size(); ++l) {
    const bool all = std::all_of(everywhere.begin(), everywhere.end(), [&](int o) { return is_real(o, l); });
    if (all && (!best || area(levels_[l].corners) < (1 - 1e-9) * area(levels_[*best].corners))) best = l;
  }
  const auto& frame = levels_[best.value_or(first_layer())].corners;
  for (const Eigen::Index axis : {0, 1})
    drawn_widths_[static_cast<std::size_t>(axis)] = half_widths(frame, middle_, axis);
  parent_ = nesting(branch_.outlines);
  std::vector<bool> wanted;
  for (int o = 0; o < outline_count(); ++o) {
    bool any = false;
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) any = any || has_material_in(o, l);
    wanted.push_back(any);
  }
  drawing_ = plan_drawing(frame, branch_.outlines, wanted, place_.on_top);
}

void BranchLevels::find_nodes() {
  nodes_.assign(drawing_.quads.vertices.begin(), drawing_.quads.vertices.end());
  on_floor_.assign(nodes_.size(), false);
  outline_at_.assign(nodes_.size(), -1);
  for (std::size_t e = 0; e < drawing_.quads.edges.size(); ++e) {
    const QuadEdge& edge = drawing_.quads.edges[e];
    if (edge.profile_edge < 4) continue;
    const NurbsCurve curve = drawing_.curve(static_cast<int>(e));
    for (const auto& [node, t] : {std::pair(edge.start, 0.0), std::pair(edge.end, 1.0)}) {
      nodes_[number(node)] = curve.point(Parameter<1>(t)).head<2>();
      const int o = drawing_.outline_of[number(edge.profile_edge)];
      if (o < 0) continue;
      on_floor_[number(node)] = true;
      outline_at_[number(node)] = o;
    }
  }
}

/// Beside what is on an outline: corners of what is inside one.
void BranchLevels::find_floor() {
  for (std::size_t q = 0; q < drawing_.quads.quads.size(); ++q)
    if (is_inside(static_cast<int>(q)))
      for (const geometry::EdgeUse& side : drawing_.quads.quads[q].sides) {
        const QuadEdge& edge = drawing_.quads.edges[number(side.edge.value)];
        on_floor_[number(edge.start)] = on_floor_[number(edge.end)] = true;
      }
}

/// Walls that a layer has stay where they are; beside them the drawing is squeezed or stretched along x and
/// y, so that its sides are the layer's.
void BranchLevels::find_stretch(std::size_t l) {
  BranchLevel& level = levels_[l];
  if (!level.shape) return;
  Eigen::Vector2d kept(0, 0);
  for (int o = 0; o < outline_count(); ++o)
    if (is_real(o, l)) kept = kept.cwiseMax(half_width(outline(o), middle_));
  for (const Eigen::Index axis : {0, 1}) {
    const auto a = static_cast<std::size_t>(axis);
    level.kept[a] = kept[axis];
    const std::array<double, 2> here = half_widths(level.corners, middle_, axis);
    for (const std::size_t side : {0U, 1U}) {
      if (level.kept[a] < (1 - least_left) * std::min(drawn_widths_[a][side], here[side]))
        level.stretch[a][side] = (here[side] - level.kept[a]) / (drawn_widths_[a][side] - level.kept[a]);
      else if (axis == 1)
        throw Error(
            ErrorCode::unsupported,
            fmt::format("{} leaves no room in a layer of its body that reaches {:.3g} m to a side of it",
                        describe(solid_, outline(0).walls.front()), here[side]));
    }
  }
}

/// Where a place of the drawing is at a level.
Eigen::Vector2d BranchLevels::at_level(const Eigen::Vector2d& plan, std::size_t l) const {
  const BranchLevel& level = levels_[l];
  if (!level.shape) return plan;
  Eigen::Vector2d result = plan;
  for (const Eigen::Index axis : {0, 1})
    result[axis] = middle_[axis] + way_at_level(plan[axis] - middle_[axis], axis, level);
  return result;
}

double BranchLevels::way_at_level(double way, Eigen::Index axis, const BranchLevel& level) {
  const auto a = static_cast<std::size_t>(axis);
  const double beyond = std::abs(way) - level.kept[a];
  if (beyond < 0) return way;
  return std::copysign(level.kept[a] + level.stretch[a][way < 0 ? 0 : 1] * beyond, way);
}

/// An outline that has no wall at a level becomes narrower as a whole, so that it stays round.
Eigen::Vector2d BranchLevels::of_outline_at_level(int o, const Eigen::Vector2d& plan, std::size_t l) const {
  if (o < 0 || !levels_[l].shape || is_real(o, l)) return at_level(plan, l);
  const Eigen::Vector2d half = half_width(outline(o), middle_);
  Eigen::Vector2d result = plan;
  for (const Eigen::Index axis : {0, 1}) {
    const double way = plan[axis] - middle_[axis], end = std::copysign(half[axis], way);
    result[axis] = middle_[axis] + way * way_at_level(end, axis, levels_[l]) / end;
  }
  return result;
}

Eigen::Vector2d BranchLevels::plan_of(int node, std::size_t level) const {
  return of_outline_at_level(outline_at_[number(node)], nodes_[number(node)], level);
}

int BranchLevels::outline_of(int edge) const {
  const int drawn = drawing_.quads.edges[number(edge)].profile_edge;
  return drawn < 0 ? -1 : drawing_.outline_of[number(drawn)];
}

NurbsCurve BranchLevels::plan_curve(int edge, std::size_t level) const {
  NurbsCurve plan = drawing_.curve(edge);
  Eigen::Vector2d widest(0, 0);
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
    widest = widest.cwiseMax((plan.point(Parameter<1>(t)).head<2>() - middle_).cwiseAbs());
  const auto& kept = levels_[level].kept;
  if (widest.x() <= kept[0] + tolerance_ && widest.y() <= kept[1] + tolerance_) return plan;
  const QuadEdge& drawn = drawing_.quads.edges[number(edge)];
  if (plan.size() == 2)
    return geometry::segment(in_plane(plan_of(drawn.start, level)), in_plane(plan_of(drawn.end, level)));
  Eigen::Matrix3Xd points = plan.control_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i).head<2>() = of_outline_at_level(outline_of(edge), points.col(i).head<2>(), level);
  return NurbsCurve(plan.knots(), points, plan.weights());
}

}  // namespace isopatch::segmentation
