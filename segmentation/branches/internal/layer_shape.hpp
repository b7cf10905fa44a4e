#pragma once

#include <optional>

#include "segmentation/branches/internal/column.hpp"

namespace isopatch::segmentation {

/// The height of a layer of a column over its plan: a plane across the view, or what is straight along x, as
/// planes, cylinders and extruded curves are.
class LayerShape {
 public:
  /// @throws Error unsupported  another one
  LayerShape(const geometry::CellComplex& complex, const PlanView& view, const ColumnLayer& layer,
             double tolerance);

  bool is_flat() const { return !across_; }
  double height(const Eigen::Vector2d& plan) const;
  /// What lies over a curve of the plan (z = 0): exact over lines, else a spline, to 1e-9 of its length.
  geometry::NurbsCurve lifted(const geometry::NurbsCurve& plan) const;
  /// The whole surface of a layer that is not flat, x along the second parameter, its normal up.
  geometry::NurbsSurface surface() const;
  /// A curve on the layer as a curve in its domain, with the same parameter.
  geometry::NurbsCurve trace(const geometry::NurbsCurve& curve) const;
  /// Distance of a layer that is round about the view's x from it; nothing of others.
  std::optional<double> radius() const;

 private:
  double share_at(double y) const;
  bool is_smooth(const geometry::NurbsCurve& plan) const;
  void find_centre(double tolerance);

  PlanView view_;
  double close_ = 0;  // what counts as no distance of curves, m
  double height_ = 0;
  double low_ = 0, high_ = 0;                        // x of its ends
  std::optional<geometry::NurbsCurve> across_ = {};  // in coordinates of the view, at x = low_, y descending
  std::optional<Eigen::Vector2d> centre_ = {};       // (y, z) of what is round
};

}  // namespace isopatch::segmentation
