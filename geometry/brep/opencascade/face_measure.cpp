#include "geometry/brep/opencascade/internal/face_measure.hpp"

#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "geometry/base/adaptive_integral.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/face_contour.hpp"
#include "geometry/brep/opencascade/internal/smooth_ranges.hpp"

namespace isopatch::geometry {
namespace {

/// Area and flux.
using FaceValues = Eigen::Array2d;

// Points of the surface after which a row and a face are left as they are: a second or so for a face.
constexpr int most_of_row = 3000, most_of_face = 2000000;

Handle(Geom_Surface) untrimmed(const Handle(Geom_Surface) & surface) {
  const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
  return trimmed.IsNull() ? surface : trimmed->BasisSurface();
}

class FaceIntegral {
 public:
  FaceIntegral(const TopoDS_Face& face, const Handle(Geom_Surface) & surface,
               const FaceMeasureOptions& options)
      : options_(options), surface_(untrimmed(surface)), contour_(face_contour(face, surface_)) {
    for (const ContourCurve& walked : contour_.curves) curves_.emplace_back(walked.curve);
    plane_ = surface_.GetType() == GeomAbs_Plane;
    set_box();
    set_cuts();
  }

  FaceMeasure make() {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < curves_.size(); ++i) add_stretches(static_cast<int>(i), stretches);
    const auto allowed = [&](const FaceValues& total) -> FaceValues {
      if (points_ > most_of_face) return FaceValues::Constant(std::numeric_limits<double>::infinity());
      return options_.relative * std::abs(total(0)) * FaceValues(1, options_.size);
    };
    AdaptiveIntegral<2> integrate;
    const auto found = integrate([&](int curve, double t) { return on_contour(curve, t); }, stretches,
                                 allowed, most_of_face);
    const double bridge = contour_.longest_bridge;
    FaceValues open = bridge * bridge * FaceValues(1, options_.size);
    if (found.value(0) < 0) open += found.value.abs();  // the loops run around what is outside
    const FaceValues error = found.error + rise_ * inner_error_ + open;
    return {{std::abs(found.value(0)), error(0)}, {found.value(1), error(1)}, open(1)};
  }

 private:
  Eigen::Vector2d place(int curve, double t) const {
    return to_eigen(curves_[static_cast<std::size_t>(curve)].Value(t));
  }

  void set_box() {
    left_ = low_ = std::numeric_limits<double>::infinity();
    right_ = high_ = -left_;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      constexpr int pieces = 8;
      const ContourCurve& walked = contour_.curves[i];
      double before = 0;
      for (int k = 0; k <= pieces; ++k) {
        const Eigen::Vector2d at =
            place(static_cast<int>(i), walked.first + (walked.last - walked.first) * k / pieces);
        left_ = std::min(left_, at.x());
        right_ = std::max(right_, at.x());
        low_ = std::min(low_, at.y());
        high_ = std::max(high_, at.y());
        if (k > 0) rise_ += std::abs(at.y() - before);
        before = at.y();
      }
    }
  }

  // A little beyond the box, since it is a box of samples.
  void set_cuts() {
    if (plane_ || curves_.empty()) return;
    const double u = right_ - left_, v = high_ - low_;
    u_knots_ = knots_between(surface_, Direction::u, left_ - u, right_ + u);
    v_knots_ = knots_between(surface_, Direction::v, low_ - v, high_ + v);
    u_cuts_ = u_knots_;
    if (!is_angle(surface_, Direction::u)) return;
    const double quarter = std::numbers::pi / 2;
    for (int i = -4; i <= 8; ++i) u_cuts_.push_back(left_ + i * quarter);
    std::sort(u_cuts_.begin(), u_cuts_.end());
  }

  void add_stretches(int curve, std::vector<Stretch>& stretches) const {
    const ContourCurve& walked = contour_.curves[static_cast<std::size_t>(curve)];
    const std::vector<double> ranges = smooth_ranges(walked.curve, walked.first, walked.last);
    for (std::size_t i = 0; i + 1 < ranges.size(); ++i) {
      std::vector<double> cuts = {ranges[i], ranges[i + 1]};
      add_crossings(curve, ranges[i], ranges[i + 1], cuts);
      std::sort(cuts.begin(), cuts.end());
      if (ranges[i] > ranges[i + 1]) std::reverse(cuts.begin(), cuts.end());
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        if (cuts[k] != cuts[k + 1]) stretches.push_back({curve, cuts[k], cuts[k + 1]});
    }
  }

  // Where the curve crosses knots of the surface. Two crossings between samples stay unseen: that costs
  // refinement, not accuracy.
  void add_crossings(int curve, double from, double to, std::vector<double>& cuts) const {
    if (u_knots_.empty() && v_knots_.empty()) return;
    constexpr int samples = 8;
    double before = from;
    Eigen::Vector2d at_before = place(curve, from);
    for (int i = 1; i <= samples; ++i) {
      const double t = i == samples ? to : from + (to - from) * i / samples;
      const Eigen::Vector2d at = place(curve, t);
      for (const auto& [axis, knots] : {std::pair(0, &u_knots_), std::pair(1, &v_knots_)}) {
        const auto [low, high] = std::minmax(at_before(axis), at(axis));
        for (auto knot = std::upper_bound(knots->begin(), knots->end(), low);
             knot != knots->end() && *knot < high; ++knot)
          cuts.push_back(crossing(curve, axis, *knot, before, t));
      }
      before = t;
      at_before = at;
    }
  }

  double crossing(int curve, int axis, double knot, double from, double to) const {
    const bool rising = place(curve, to)(axis) > knot;
    for (int i = 0; i < 40; ++i) {
      const double middle = (from + to) / 2;
      ((place(curve, middle)(axis) > knot) == rising ? to : from) = middle;
    }
    return (from + to) / 2;
  }

  FaceValues on_contour(int curve, double t) {
    gp_Pnt2d at;
    gp_Vec2d along;
    curves_[static_cast<std::size_t>(curve)].D1(t, at, along);
    follow_edge(curve, t, at, along);
    const double u_range = right_ - left_, v_range = high_ - low_;
    if (std::abs(along.Y()) * u_range <= 1e-14 * std::abs(along.X()) * v_range) return FaceValues::Zero();
    if (std::abs(at.X() - left_) <= 1e-14 * u_range) return FaceValues::Zero();
    return along.Y() * along_u(at.X(), at.Y());
  }

  // From the point of the curve in the domain to the one whose place is nearest to the edge's, by Newton's
  // method. Where that leads away, or the surface degenerates, the curve is left as it is.
  void follow_edge(int curve, double t, gp_Pnt2d& at, gp_Vec2d& along) {
    const Handle(Geom_Curve)& edge = contour_.curves[static_cast<std::size_t>(curve)].edge;
    if (edge.IsNull() || plane_) return;
    gp_Pnt target, place;
    gp_Vec direction, along_u, along_v;
    edge->D1(t, target, direction);
    Eigen::Vector2d uv = to_eigen(at);
    const Eigen::Vector2d range(right_ - left_, high_ - low_);
    for (int step = 0; step < 3; ++step) {
      surface_.D1(uv.x(), uv.y(), place, along_u, along_v);
      Eigen::Matrix<double, 3, 2> tangents;
      tangents << to_eigen(along_u), to_eigen(along_v);
      const Eigen::Matrix2d metric = tangents.transpose() * tangents;
      if (!(metric.determinant() > 1e-12 * metric(0, 0) * metric(1, 1))) return;
      const Eigen::Matrix2d inverse = metric.inverse();
      if (step == 2) {
        const Eigen::Vector2d turned = inverse * tangents.transpose() * to_eigen(direction);
        at = gp_Pnt2d(uv.x(), uv.y());
        along = gp_Vec2d(turned.x(), turned.y());
        return;
      }
      const Eigen::Vector2d move = inverse * tangents.transpose() * (to_eigen(target) - to_eigen(place));
      if (!(move.cwiseAbs().array() <= 1e-2 * range.array()).all()) return;
      uv += move;
    }
  }

  // From the left end of the domain to u.
  FaceValues along_u(double u, double v) {
    if (plane_) return (u - left_) * density(u, v);
    std::vector<Stretch>& stretches = row_;
    stretches.clear();
    const auto [low, high] = std::minmax(left_, u);
    double from = low;
    for (auto cut = std::upper_bound(u_cuts_.begin(), u_cuts_.end(), low);
         cut != u_cuts_.end() && *cut < high; ++cut) {
      stretches.push_back({0, from, *cut});
      from = *cut;
    }
    stretches.push_back({0, from, high});
    const double relative = 0.1 * options_.relative;
    const auto allowed = [&](const FaceValues& total) {
      return FaceValues(relative * total(0) * FaceValues(1, options_.size));
    };
    const auto found =
        integrate_row_([&](int, double at) { return density(at, v); }, stretches, allowed, most_of_row);
    inner_error_ = inner_error_.max(found.error);
    return u < left_ ? FaceValues(-found.value) : found.value;
  }

  FaceValues density(double u, double v) {
    ++points_;
    gp_Pnt at;
    gp_Vec along_u, along_v;
    surface_.D1(u, v, at, along_u, along_v);
    const Eigen::Vector3d normal = to_eigen(along_u).cross(to_eigen(along_v));
    return {normal.norm(), (to_eigen(at) - options_.reference).dot(normal)};
  }

  const FaceMeasureOptions& options_;
  GeomAdaptor_Surface surface_;  // one of our own: it remembers the last span
  FaceContour contour_;
  std::deque<Geom2dAdaptor_Curve> curves_;
  bool plane_ = false;
  double left_ = 0, right_ = 0, low_ = 0, high_ = 0;
  double rise_ = 0;  // of all curves together, up and down
  std::vector<double> u_knots_, v_knots_, u_cuts_;
  std::vector<Stretch> row_;
  AdaptiveIntegral<2> integrate_row_;
  FaceValues inner_error_ = FaceValues::Zero();
  int points_ = 0;
};

}  // namespace

FaceMeasure measure_face(const TopoDS_Face& face, const Handle(Geom_Surface) & surface,
                         const FaceMeasureOptions& options) {
  try {
    return FaceIntegral(face, surface, options).make();
  } catch (const Standard_Failure&) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    return {{0, unknown}, {0, unknown}, 0};
  }
}

}  // namespace isopatch::geometry
