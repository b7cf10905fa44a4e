#include "segmentation/reconstruction/internal/slide_rulings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/base/sparse_lu.hpp"
#include "geometry/splines/basis.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;

constexpr int most_slides = 12;
constexpr int most_halvings = 6;
// Share of the height within which a point is on a plane.
constexpr double on_plane = 1e-4;
// What it costs that neighbouring control points slide by different ways, beside what it costs that points
// are off: slides differ by millimetres where points are to be off by micrometres.
constexpr double stiffness = 1e-4;

class RulingSlider {
 public:
  RulingSlider(const RuledCurves& start, RuledPoints points, double tolerance)
      : start_(start), curves_(start), points_(std::move(points)), tolerance_(tolerance) {
    x_ = points_.up.unitOrthogonal();
    y_ = points_.up.cross(x_);
    u_.resize(points_.v.size());
    for (Eigen::Index k = 0; k < u_.size(); ++k) {
      double& v = points_.v[k];
      if (std::abs(v) < on_plane) v = 0;
      if (std::abs(1 - v) < on_plane) v = 1;
      u_[k] = nearest_of_samples(points_.points.col(k), v);
    }
  }

  RuledCurves slid() {
    for (int round = 0; round < most_halvings; ++round) {
      for (int i = 0; i < most_slides; ++i)
        if (slide() < 1e-3 * tolerance_) break;
      measure();
      if (curves_.largest_on_curves <= tolerance_ || !halve()) break;
    }
    return curves_;
  }

 private:
  /// A point at a height and the derivatives there.
  Eigen::Vector3d at(double u, double v, int order) const {
    return (1 - v) * curves_.low.derivative(geometry::Parameter<1>(u), {order}) +
           v * curves_.high.derivative(geometry::Parameter<1>(u), {order});
  }

  double nearest_of_samples(const Eigen::Vector3d& point, double v) const {
    constexpr int places = 200;
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= places; ++i) {
      const double u = double(i) / places, off = (at(u, v, 0) - point).squaredNorm();
      if (!(off < least)) continue;
      least = off;
      best = u;
    }
    return best;
  }

  double nearest(const Eigen::Vector3d& point, double u, double v) const {
    for (int round = 0; round < 20; ++round) {
      const Eigen::Vector3d slope = at(u, v, 1);
      const double next = std::clamp(u + slope.dot(point - at(u, v, 0)) / slope.squaredNorm(), 0.0, 1.0);
      const bool done = std::abs(next - u) < 1e-12;
      u = next;
      if (done) break;
    }
    return u;
  }

  /// Across the section at a point's height, unit.
  Eigen::Vector3d across(double u, double v) const { return points_.up.cross(at(u, v, 1)).normalized(); }

  /// One Gauss-Newton step; the largest way of a control point, m.
  double slide() {
    const int n = curves_.low.size(), unknowns = 4 * n;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    for (Eigen::Index k = 0; k < u_.size(); ++k) {
      const double v = points_.v[k], u = u_[k] = nearest(points_.points.col(k), u_[k], v);
      const Eigen::Vector3d normal = across(u, v);
      const double off = normal.dot(points_.points.col(k) - at(u, v, 0));
      const geometry::BasisValues basis = geometry::basis(curves_.low.knots(0), u);
      std::vector<std::pair<Eigen::Index, double>> row;
      for (Eigen::Index i = 0; i < basis.values.cols(); ++i)
        for (const auto& [curve, share] : {std::pair(0, 1 - v), std::pair(1, v)})
          for (const auto& [axis, along] : {std::pair(0, normal.dot(x_)), std::pair(1, normal.dot(y_))})
            row.emplace_back(2 * (n * curve + basis.first + i) + axis, share * along * basis.values(0, i));
      for (const auto& [a, first] : row) {
        right[a] += first * off;
        for (const auto& [b, second] : row) matrix(a, b) += first * second;
      }
    }
    add_stiffness(matrix, right);
    for (const int fixed : {0, n - 1, n, 2 * n - 1})
      for (const int a : {2 * fixed, 2 * fixed + 1}) {
        matrix.row(a).setZero();
        matrix(a, a) = 1;
        right[a] = 0;
      }
    const auto step = solve_by_lu(Eigen::SparseMatrix<double>(matrix.sparseView()), right);
    if (!step) return 0;
    curves_.low = moved(curves_.low, step->col(0).head(2 * n));
    curves_.high = moved(curves_.high, step->col(0).tail(2 * n));
    return step->cwiseAbs().maxCoeff();
  }

  /// Slides from the start differ little from those of the next control point.
  void add_stiffness(Eigen::MatrixXd& matrix, Eigen::VectorXd& right) const {
    const int n = curves_.low.size();
    for (const auto& [curve, now, before] :
         {std::tuple(0, &curves_.low, &start_.low), std::tuple(1, &curves_.high, &start_.high)}) {
      const Eigen::Matrix3Xd slid = now->control_points() - before->control_points();
      for (int i = 0; i + 1 < n; ++i) {
        const Eigen::Vector3d differs = slid.col(i + 1) - slid.col(i);
        for (const auto& [axis, by] : {std::pair(0, differs.dot(x_)), std::pair(1, differs.dot(y_))}) {
          const int a = 2 * (n * curve + i) + axis, b = a + 2;
          matrix(a, a) += stiffness;
          matrix(b, b) += stiffness;
          matrix(a, b) -= stiffness;
          matrix(b, a) -= stiffness;
          right[a] += stiffness * by;
          right[b] -= stiffness * by;
        }
      }
    }
  }

  NurbsCurve moved(const NurbsCurve& curve, const Eigen::VectorXd& step) const {
    Eigen::Matrix3Xd points = curve.control_points();
    for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) += step[2 * i] * x_ + step[2 * i + 1] * y_;
    return NurbsCurve(curve.knots(), points);
  }

  double off(Eigen::Index k) const {
    const double u = nearest(points_.points.col(k), u_[k], points_.v[k]);
    return (points_.points.col(k) - at(u, points_.v[k], 0)).norm();
  }
  bool is_on_curve(Eigen::Index k) const { return points_.v[k] == 0 || points_.v[k] == 1; }

  void measure() {
    curves_.largest = curves_.largest_on_curves = 0;
    for (Eigen::Index k = 0; k < u_.size(); ++k) {
      curves_.largest = std::max(curves_.largest, off(k));
      if (is_on_curve(k)) curves_.largest_on_curves = std::max(curves_.largest_on_curves, off(k));
    }
  }

  bool halve() {
    const geometry::KnotVector& knots = curves_.low.knots(0);
    std::set<double> added;
    for (Eigen::Index k = 0; k < u_.size(); ++k) {
      if (!is_on_curve(k) || off(k) <= tolerance_) continue;
      const auto span = static_cast<std::size_t>(knots.span(u_[k]));
      added.insert((knots.knots()[span] + knots.knots()[span + 1]) / 2);
    }
    if (added.empty()) return false;
    const std::vector<double> inserted(added.begin(), added.end());
    for (NurbsCurve* curve : {&start_.low, &start_.high, &curves_.low, &curves_.high})
      *curve = geometry::insert_knots(*curve, 0, inserted);
    return true;
  }

  RuledCurves start_, curves_;
  RuledPoints points_;
  Eigen::VectorXd u_;
  double tolerance_;
  Eigen::Vector3d x_, y_;
};

}  // namespace

RuledCurves slide_rulings(const RuledCurves& start, RuledPoints points, double tolerance) {
  return RulingSlider(start, std::move(points), tolerance).slid();
}

}  // namespace isopatch::segmentation
