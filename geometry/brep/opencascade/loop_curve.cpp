#include "geometry/brep/opencascade/internal/loop_curve.hpp"

#include <Geom2dAPI_Interpolate.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <cmath>
#include <utility>

#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {

LoopCurve::LoopCurve(Handle(Geom_Surface) surface, Handle(Geom2d_BSplineCurve) curve)
    : surface_(std::move(surface)), curve_(std::move(curve)), points_(3, samples + 1) {
  for (int i = 0; i <= samples; ++i) points_.col(i) = point(double(i) / samples);
}

Eigen::Vector2d LoopCurve::domain_point(double t) const {
  const double first = curve_->FirstParameter(), last = curve_->LastParameter();
  return to_eigen(curve_->Value(first + (last - first) * t));
}

Eigen::Vector3d LoopCurve::point(double t) const {
  const Eigen::Vector2d uv = domain_point(t);
  return to_eigen(surface_->Value(uv.x(), uv.y()));
}

double LoopCurve::length() const {
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += (points_.col(i + 1) - points_.col(i)).norm();
  return sum;
}

double LoopCurve::nearest(const Eigen::Vector3d& target) const {
  Eigen::Index best = 0;
  (points_.colwise() - target).colwise().squaredNorm().minCoeff(&best);
  double low = std::max(0.0, double(best - 1) / samples), high = std::min(1.0, double(best + 1) / samples);
  const auto distance = [&](double t) { return (point(t) - target).squaredNorm(); };
  // Golden section: round-off of the squared distance limits it to about 1e-8 of the curve.
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double a = high - ratio * (high - low), b = low + ratio * (high - low);
  double at_a = distance(a), at_b = distance(b);
  for (int i = 0; i < 60 && high - low > 1e-12; ++i)
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      a = high - ratio * (high - low), at_a = distance(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + ratio * (high - low), at_b = distance(b);
    }
  const double t = (low + high) / 2;
  for (const double end : {0.0, 1.0})
    if (distance(end) <= distance(t)) return end;
  return t;
}

Handle(Geom2d_BSplineCurve) LoopCurve::over(double first, double last, bool reversed) const {
  Handle(Geom2d_BSplineCurve) result = Handle(Geom2d_BSplineCurve)::DownCast(curve_->Copy());
  if (reversed) result->Reverse();
  TColStd_Array1OfReal knots(1, result->NbKnots());
  result->Knots(knots);
  const double from = knots.First(), to = knots.Last();
  for (int i = 1; i <= knots.Length(); ++i)
    knots(i) = first + (last - first) * (knots(i) - from) / (to - from);
  knots(knots.Length()) = last;
  result->SetKnots(knots);
  return result;
}

CurveMatch match(const LoopCurve& first, const LoopCurve& second) {
  constexpr int count = 10;
  CurveMatch result;
  int backwards = 0;
  double before = 0;
  for (int i = 0; i <= count; ++i) {
    const Eigen::Vector3d target = first.point(double(i) / count);
    const double t = second.nearest(target);
    result.distance = std::max(result.distance, (second.point(t) - target).norm());
    // On closed curves the ends jump: only the inner steps count.
    if (i > 1 && i < count) backwards += t < before ? 1 : -1;
    before = t;
  }
  result.reversed = backwards > 0;
  return result;
}

namespace {

double largest_distance(const LoopCurve& leader, const LoopCurve& follower, const Geom2d_BSplineCurve& curve,
                        double first, double last) {
  constexpr int count = 97;
  double result = 0;
  for (int i = 0; i <= count; ++i) {
    const double t = double(i) / count;
    const gp_Pnt2d uv = curve.Value(first + (last - first) * t);
    const Eigen::Vector3d there = to_eigen(follower.surface()->Value(uv.X(), uv.Y()));
    result = std::max(result, (there - leader.point(t)).norm());
  }
  return result;
}

// Through the points nearest to `count` points of the leader.
Handle(Geom2d_BSplineCurve) through_nearest(const LoopCurve& leader, const LoopCurve& follower, bool reversed,
                                            int count, double first, double last) {
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, count);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count);
  for (int i = 0; i < count; ++i) {
    const double t = double(i) / (count - 1);
    const bool at_end = i == 0 || i == count - 1;
    const double s = at_end ? (reversed ? 1 - t : t) : follower.nearest(leader.point(t));
    const Eigen::Vector2d uv = follower.domain_point(s);
    points->SetValue(i + 1, gp_Pnt2d(uv.x(), uv.y()));
    parameters->SetValue(i + 1, first + (last - first) * t);
  }
  Geom2dAPI_Interpolate interpolation(points, parameters, false, 1e-14);
  interpolation.Perform();
  return interpolation.IsDone() ? interpolation.Curve() : Handle(Geom2d_BSplineCurve)();
}

}  // namespace

FollowingCurve follow(const LoopCurve& leader, const LoopCurve& follower, const CurveMatch& match,
                      double first, double last, double enough) {
  FollowingCurve best;
  best.curve = follower.over(first, last, match.reversed);
  best.distance = largest_distance(leader, follower, *best.curve, first, last);
  const double wanted = std::max(1.2 * match.distance, enough);
  for (int count = 17; count <= 257 && best.distance > wanted; count = 2 * count - 1) {
    const auto curve = through_nearest(leader, follower, match.reversed, count, first, last);
    if (curve.IsNull()) continue;
    const double distance = largest_distance(leader, follower, *curve, first, last);
    if (distance < best.distance) best = {curve, distance};
  }
  return best;
}

}  // namespace isopatch::geometry
