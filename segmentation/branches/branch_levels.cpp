#include "segmentation/branches/internal/branch_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;
using geometry::Parameter;

/// Of a layer's half width, beside what is as it is drawn: less would fold hexahedra.
constexpr double least_left = 0.02;

std::size_t number(int i) {
  return static_cast<std::size_t>(i);
}

double area(const std::array<Eigen::Vector2d, 4>& corners) {
  const Eigen::Vector2d a = corners[2] - corners[0], b = corners[3] - corners[1];
  return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
}

double half_width(const Outline& outline) {
  double result = 0;
  for (const PlanCurve& curve : outline.curves)
    for (int i = 0; i <= 64; ++i) result = std::max(result, std::abs(curve.point(i / 64.0).y()));
  return result;
}

std::array<double, 2> half_widths(const std::array<Eigen::Vector2d, 4>& corners) {
  std::array<double, 2> sum = {0, 0};
  for (const Eigen::Vector2d& corner : corners) sum[corner.y() < 0 ? 0 : 1] += std::abs(corner.y());
  return {sum[0] / 2, sum[1] / 2};
}

}  // namespace

BranchLevels::BranchLevels(const geometry::Brep& solid, const geometry::CellComplex& body,
                           const Branch& branch, const BranchPlace& place, const Column& column,
                           double tolerance)
    : solid_(solid), branch_(branch), place_(place), tolerance_(tolerance) {
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
  drawn_widths_ = half_widths(frame);
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
  for (std::size_t e = 0; e < drawing_.quads.edges.size(); ++e) {
    const QuadEdge& edge = drawing_.quads.edges[e];
    if (edge.profile_edge < 4) continue;
    const NurbsCurve curve = drawing_.curve(static_cast<int>(e));
    for (const auto& [node, t] : {std::pair(edge.start, 0.0), std::pair(edge.end, 1.0)}) {
      nodes_[number(node)] = curve.point(Parameter<1>(t)).head<2>();
      if (drawing_.outline_of[number(edge.profile_edge)] >= 0) on_floor_[number(node)] = true;
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

/// Walls that a layer has stay where they are; beside them the drawing is squeezed or stretched across the
/// axis, so that its sides are the layer's.
void BranchLevels::find_stretch(std::size_t l) {
  BranchLevel& level = levels_[l];
  if (!level.shape) return;
  for (int o = 0; o < outline_count(); ++o)
    if (is_real(o, l)) level.kept = std::max(level.kept, half_width(outline(o)));
  const std::array<double, 2> here = half_widths(level.corners);
  for (const std::size_t side : {0U, 1U}) {
    level.stretch[side] = (here[side] - level.kept) / (drawn_widths_[side] - level.kept);
    if (!(level.kept < (1 - least_left) * std::min(drawn_widths_[side], here[side])))
      throw Error(
          ErrorCode::unsupported,
          fmt::format("{} leaves no room in a layer of its body that reaches {:.3g} m to a side of it",
                      describe(solid_, outline(0).walls.front()), here[side]));
  }
}

/// Where a place of the drawing is at a level.
Eigen::Vector2d BranchLevels::at_level(const Eigen::Vector2d& plan, std::size_t l) const {
  const BranchLevel& level = levels_[l];
  const double beyond = std::abs(plan.y()) - level.kept;
  if (!level.shape || beyond < 0) return plan;
  return {plan.x(), std::copysign(level.kept + level.stretch[plan.y() < 0 ? 0 : 1] * beyond, plan.y())};
}

Eigen::Vector2d BranchLevels::plan_of(int node, std::size_t level) const {
  return at_level(nodes_[number(node)], level);
}

NurbsCurve BranchLevels::plan_curve(int edge, std::size_t level) const {
  NurbsCurve plan = drawing_.curve(edge);
  double widest = 0;
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
    widest = std::max(widest, std::abs(plan.point(Parameter<1>(t)).y()));
  if (widest <= levels_[level].kept + tolerance_) return plan;
  Eigen::Matrix3Xd points = plan.control_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i).head<2>() = at_level(points.col(i).head<2>(), level);
  return NurbsCurve(plan.knots(), points, plan.weights());
}

}  // namespace isopatch::segmentation
