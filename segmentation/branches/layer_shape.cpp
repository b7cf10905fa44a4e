#include "segmentation/branches/internal/layer_shape.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/base/angle.hpp"
#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/sweeps/interpolate.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;
using geometry::Parameter;

NurbsCurve curve_of(const geometry::CellComplex& complex, geometry::EdgeUse use) {
  const auto& shape = std::get<NurbsCurve>(complex.curve(complex.edge(use.edge).curve).shape);
  return use.reversed ? reversed(shape, 0) : shape;
}

NurbsCurve mapped(const NurbsCurve& curve, const auto& map) {
  Eigen::Matrix3Xd points = curve.control_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = map(Eigen::Vector3d(points.col(i)));
  return NurbsCurve(curve.knots(), points, curve.weights());
}

}  // namespace

LayerShape::LayerShape(const geometry::CellComplex& complex, const PlanView& view, const ColumnLayer& layer,
                       double tolerance)
    : view_(view), close_(1e-2 * tolerance) {
  std::vector<NurbsCurve> sides;
  double low = 1e300, high = -1e300;
  for (const geometry::EdgeUse& use : layer.sides) {
    // In coordinates of the view.
    sides.push_back(mapped(curve_of(complex, use), [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(view.flat(p).x(), view.flat(p).y(), view.height(p));
    }));
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      const double z = sides.back().point(Parameter<1>(t)).z();
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  height_ = (low + high) / 2;
  if (high - low < tolerance) return;
  for (const NurbsCurve& side : sides) {
    const Eigen::Vector3d a = side.point(Parameter<1>(0)), m = side.point(Parameter<1>(0.5)),
                          b = side.point(Parameter<1>(1));
    const bool is_across = std::abs(a.x() - b.x()) < tolerance && std::abs(a.x() - m.x()) < tolerance;
    const bool is_along =
        std::abs(a.y() - b.y()) < tolerance && std::abs(a.z() - b.z()) < tolerance && side.degree(0) == 1;
    if (!is_across && !is_along)
      throw Error(ErrorCode::unsupported,
                  "a branch reaches a face that is neither flat nor straight along the body");
    if (is_along) continue;
    if (!across_) low_ = high_ = a.x();
    low_ = std::min(low_, a.x());
    high_ = std::max(high_, a.x());
    if (!across_ || a.x() <= low_) across_ = b.y() < a.y() ? side : reversed(side, 0);
  }
  if (across_->degree(0) > 1) find_centre(tolerance);
}

void LayerShape::find_centre(double tolerance) {
  const auto at = [&](double t) { return Eigen::Vector2d(across_->point(Parameter<1>(t)).tail<2>()); };
  const Eigen::Vector2d a = at(0), u = at(0.5) - a, v = at(1) - a;
  const double twice_area = 2 * (u.x() * v.y() - u.y() * v.x());
  const Eigen::Vector2d centre = a + Eigen::Vector2d(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                                                     u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                                         twice_area;
  for (const double t : {0.2, 0.7})
    if (!(std::abs((at(t) - centre).norm() - (a - centre).norm()) < tolerance)) return;
  centre_ = centre;
  if (centre.norm() < tolerance) centre_ = Eigen::Vector2d::Zero();
}

double LayerShape::share_at(double y) const {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (across_->point(Parameter<1>(middle)).y() > y ? low : high) = middle;
  }
  return (low + high) / 2;
}

double LayerShape::height(const Eigen::Vector2d& plan) const {
  return is_flat() ? height_ : across_->point(Parameter<1>(share_at(plan.y()))).z();
}

std::optional<double> LayerShape::radius() const {
  if (is_flat()) return std::nullopt;
  if (!centre_ || !centre_->isZero()) return std::nullopt;
  const Eigen::Vector3d middle = across_->point(Parameter<1>(0.5));
  return std::hypot(middle.y(), middle.z());
}

NurbsCurve LayerShape::lifted(const NurbsCurve& plan) const {
  const auto in_space = [&](const Eigen::Vector3d& p) { return view_.point(p.head<2>(), p.z()); };
  if (is_flat())
    return mapped(plan, [&](const Eigen::Vector3d& p) { return view_.point(p.head<2>(), height_); });
  const Eigen::Vector3d a = plan.point(Parameter<1>(0)), b = plan.point(Parameter<1>(1));
  const auto on_layer = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), height(p.head<2>()));
  };
  const bool straight = plan.degree(0) == 1 && plan.size() == 2;
  if (straight && (across_->degree(0) == 1 || std::abs(a.y() - b.y()) < 1e-9 * (b - a).norm()))
    return geometry::segment(in_space(on_layer(a)), in_space(on_layer(b)));
  if (straight && centre_) {
    // A circle drawn out along x.
    const Eigen::Vector3d start = on_layer(a), end = on_layer(b);
    const Eigen::Vector2d from = start.tail<2>() - *centre_, to = end.tail<2>() - *centre_;
    const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    const NurbsCurve arc = geometry::arc_about(Eigen::Vector3d(start.x(), centre_->x(), centre_->y()),
                                               Eigen::Vector3d::UnitX(), start, Angle::radians(turn));
    return mapped(arc, [&](const Eigen::Vector3d& p) {
      return in_space({a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()), p.y(), p.z()});
    });
  }
  const auto curve = [&](double t) { return in_space(on_layer(plan.point(Parameter<1>(t)))); };
  return is_smooth(plan) ? interpolated(curve) : interpolated(curve, close_);
}

/// Whether what lies over a curve has all derivatives: on planes and cylinders, over what has them itself.
bool LayerShape::is_smooth(const NurbsCurve& plan) const {
  constexpr int most_points = 13;  // of `interpolated` for a smooth curve
  return plan.size() <= most_points && (centre_ || across_->degree(0) == 1);
}

geometry::NurbsSurface LayerShape::surface() const {
  const NurbsCurve here = mapped(*across_, [&](const Eigen::Vector3d& p) {
    return view_.point({low_, p.y()}, p.z());
  });
  return geometry::extruded(here, (high_ - low_) * view_.x);
}

NurbsCurve LayerShape::trace(const NurbsCurve& curve) const {
  const auto in_domain = [&](double t) -> Eigen::Vector3d {
    const Eigen::Vector3d p = curve.point(Parameter<1>(t));
    return {share_at(view_.flat(p).y()), (view_.flat(p).x() - low_) / (high_ - low_), 0};
  };
  if (std::abs(in_domain(0)[0] - in_domain(1)[0]) < 1e-12 && curve.degree(0) == 1)
    return geometry::segment(in_domain(0), in_domain(1));
  return is_smooth(curve) ? interpolated(in_domain) : interpolated(in_domain, close_ / (high_ - low_));
}

}  // namespace isopatch::segmentation
