#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/branches/internal/branch_place.hpp"
#include "segmentation/branches/internal/column.hpp"
#include "segmentation/branches/internal/layer_shape.hpp"
#include "segmentation/branches/internal/main_body.hpp"
#include "segmentation/branches/internal/plan_drawing.hpp"

namespace isopatch::segmentation {

/// A layer of the column, or the top of the branch.
struct BranchLevel {
  std::optional<LayerShape> shape;         ///< nothing of the top
  std::optional<double> flat;              ///< height of the top, or of a floor inside its outlines, m
  int layer = -1;                          ///< of the column
  std::array<Eigen::Vector2d, 4> corners;  ///< of a layer, seen along the view, m
  /// Half of what is as it is drawn, along x and y from the branch's middle, m.
  std::array<double, 2> kept = {0, 0};
  /// What becomes of the rest along x and y, on their low and high side.
  std::array<std::array<double, 2>, 2> stretch = {{{1, 1}, {1, 1}}};
};

/// The drawing of a branch's outlines at each level, from the top down: where it is, and where it has
/// material.
class BranchLevels {
 public:
  /// What is referred to must outlive it.
  /// @param body    has the column below the branch's place
  /// @throws Error unsupported  no layer of the body is at a floor, an outline leaves no room in one, or the
  ///                            drawing cannot be divided
  BranchLevels(const geometry::Brep& solid, const geometry::CellComplex& body, const Branch& branch,
               const BranchPlace& place, const Column& column, double tolerance);

  std::size_t size() const { return levels_.size(); }
  const BranchLevel& operator[](std::size_t level) const { return levels_[level]; }
  const PlanDrawing& drawing() const { return drawing_; }

  /// Between a level and the next.
  bool has_material(int quad, std::size_t level) const;
  /// Whether a quadrilateral lies on a floor where a level has one.
  bool is_inside(int quad) const { return around(quad) >= 0; }
  /// Whether a vertex of the drawing does.
  bool is_on_floor(int node) const { return on_floor_[static_cast<std::size_t>(node)]; }
  /// Of the body's layer, or of a floor where one is asked for, m.
  double height(std::size_t level, const Eigen::Vector2d& plan, bool on_floor) const;
  /// Where a vertex of the drawing is at a level, seen along the view, m.
  Eigen::Vector2d plan_of(int node, std::size_t level) const;
  /// Where an edge of the drawing is at a level, seen along the view: over [0, 1] in the plane z = 0.
  geometry::NurbsCurve plan_curve(int edge, std::size_t level) const;

 private:
  const Outline& outline(int o) const { return branch_.outlines[static_cast<std::size_t>(o)]; }
  int outline_count() const { return static_cast<int>(branch_.outlines.size()); }
  std::size_t first_layer() const { return place_.top ? 1 : 0; }
  /// The outline just around a quadrilateral; -1: the frame around all.
  int around(int quad) const {
    const int region = drawing_.quads.quads[static_cast<std::size_t>(quad)].region;
    return drawing_.around[static_cast<std::size_t>(region)];
  }
  void find_levels(const geometry::CellComplex& body, const Column& column);
  bool has_wall(int o, std::size_t level) const;
  bool is_real(int o, std::size_t level) const;
  bool has_material_in(int o, std::size_t level) const;
  void draw();
  void find_nodes();
  void find_floor();
  void find_stretch(std::size_t level);
  Eigen::Vector2d at_level(const Eigen::Vector2d& plan, std::size_t level) const;
  static double way_at_level(double way, Eigen::Index axis, const BranchLevel& level);
  Eigen::Vector2d of_outline_at_level(int o, const Eigen::Vector2d& plan, std::size_t level) const;
  int outline_of(int edge) const;

  const geometry::Brep& solid_;
  const Branch& branch_;
  const BranchPlace& place_;
  double tolerance_;
  std::vector<BranchLevel> levels_;
  Eigen::Vector2d middle_;  // of the outlines along x; 0 along y
  std::array<std::array<double, 2>, 2> drawn_widths_ =
      {};  // of the frame that is drawn: along x and y, on both sides
  std::vector<int> parent_;
  PlanDrawing drawing_;
  std::vector<Eigen::Vector2d> nodes_;
  std::vector<bool> on_floor_;   // by vertex of the drawing
  std::vector<int> outline_at_;  // likewise; -1: on none
  mutable std::map<std::pair<int, std::size_t>, bool> walls_;
};

}  // namespace isopatch::segmentation
