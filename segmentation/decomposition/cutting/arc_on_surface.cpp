#include "segmentation/decomposition/cutting/arc_on_surface.hpp"

#include <algorithm>
#include <vector>

#include "segmentation/decomposition/cutting/conic_arc.hpp"
#include "segmentation/decomposition/cutting/spline_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;
using geometry::Parameter;

/// The same curve between two points that are nearly its ends.
NurbsCurve between(const NurbsCurve& curve, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Eigen::Matrix3Xd points = curve.control_points();
  const Eigen::Index last = points.cols() - 1;
  const Eigen::Vector3d off_from = from - points.col(0), off_to = to - points.col(last);
  for (Eigen::Index i = 0; i <= last; ++i)
    points.col(i) += (1 - double(i) / double(last)) * off_from + double(i) / double(last) * off_to;
  points.col(0) = from;
  points.col(last) = to;
  return NurbsCurve({curve.knots(0)}, points, curve.weights());
}

/// A curve on a face's surface, followed through its domain from end to end.
class Follower {
 public:
  Follower(const geometry::Brep& source, FaceId face, const NurbsCurve& curve, const CurveEnd& from,
           const CurveEnd& to)
      : source_(source), face_(face), curve_(curve), uv_{from.uv} {
    for (int i = 1; i < pieces; ++i) uv_.push_back(domain_point(double(i) / pieces, uv_.back()));
    arrives_ = (domain_point(1, uv_.back()) - to.uv).norm() <= 1e-6 * (1 + to.uv.norm());
    uv_.push_back(to.uv);
  }

  /// Not if it has gone around the surface the other way.
  bool arrives() const { return arrives_; }
  Eigen::Vector3d operator()(double t) const {
    const double at = std::clamp(t, 0.0, 1.0) * pieces;
    const auto before = std::min(static_cast<std::size_t>(at), std::size_t{pieces - 1});
    const Eigen::Vector2d start = uv_[before] + (at - double(before)) * (uv_[before + 1] - uv_[before]);
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    result.head<2>() = t <= 0 || t >= 1 ? start : domain_point(t, start);
    return result;
  }

 private:
  static constexpr int pieces = 32;
  Eigen::Vector2d domain_point(double t, const Eigen::Vector2d& start) const {
    return source_.project(face_, curve_.point(Parameter<1>(t)), start).uv;
  }

  const geometry::Brep& source_;
  FaceId face_;
  const NurbsCurve& curve_;
  std::vector<Eigen::Vector2d> uv_;
  bool arrives_ = false;
};

}  // namespace

std::optional<geometry::CellCurve> arc_on_surface(const CellShapes& shapes, geometry::SurfaceId surface,
                                                  const geometry::PlaneSurface& plane, const CurveEnd& from,
                                                  const Eigen::Vector2d& by, const CurveEnd& to,
                                                  double tolerance) {
  const auto* face = std::get_if<FaceId>(&shapes.complex().surface(surface));
  const auto carrier = face != nullptr ? shapes.source().carrier(*face) : std::nullopt;
  if (!carrier) return std::nullopt;
  auto arc = conic_arc(*carrier, plane, from.point, shapes.point(surface, by), to.point);
  if (!arc) return std::nullopt;
  const auto end = [&](double t) { return arc->point(Parameter<1>(t)); };
  if ((end(0) - from.point).norm() + (end(1) - to.point).norm() > 1000 * tolerance) return std::nullopt;
  const NurbsCurve curve = between(*arc, from.point, to.point);
  const Follower follow(shapes.source(), *face, curve, from, to);
  if (!follow.arrives()) return std::nullopt;
  const double pace = shapes.source().derivatives(*face, by).colwise().norm().maxCoeff();
  const CurvePoints trace = [&](double t) { return follow(t); };
  geometry::CellCurve result{curve};
  result.traces.push_back({surface, interpolated(trace, following_knots({trace}, tolerance / pace))});
  return result;
}

}  // namespace isopatch::segmentation
