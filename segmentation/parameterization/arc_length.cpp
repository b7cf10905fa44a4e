#include "segmentation/parameterization/internal/arc_length.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isopatch::segmentation {

namespace {

Eigen::Matrix3Xd points_on(const std::function<Eigen::Vector3d(double)>& curve, int chords) {
  Eigen::Matrix3Xd points(3, chords + 1);
  for (int i = 0; i <= chords; ++i) points.col(i) = curve(static_cast<double>(i) / chords);
  return points;
}

/// Length of the polygon through every `step`-th point.
double length_of(const Eigen::Matrix3Xd& points, Eigen::Index step) {
  double sum = 0;
  for (Eigen::Index i = step; i < points.cols(); i += step)
    sum += (points.col(i) - points.col(i - step)).norm();
  return sum;
}

double turning_of(const Eigen::Matrix3Xd& points, double length) {
  double sum = 0;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 1; i < points.cols(); ++i) {
    const Eigen::Vector3d chord = points.col(i) - points.col(i - 1);
    if (!(chord.norm() > 1e-12 * length)) continue;
    if (!last.isZero(0)) sum += std::atan2(last.cross(chord).norm(), last.dot(chord));
    last = chord;
  }
  return sum;
}

}  // namespace

ArcLength::ArcLength(const std::function<Eigen::Vector3d(double)>& curve, int chords) {
  constexpr double settled = 1e-3;
  const int most = 16 * chords;
  Eigen::Matrix3Xd points = points_on(curve, chords);
  while (2 * chords <= most && length_of(points, 1) - length_of(points, 2) > settled * length_of(points, 1)) {
    chords *= 2;
    points = points_on(curve, chords);
  }
  const auto n = static_cast<std::size_t>(chords);
  at_.assign(n + 1, 0.0);
  for (std::size_t i = 1; i <= n; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    at_[i] = at_[i - 1] + (points.col(k) - points.col(k - 1)).norm();
  }
  turning_ = turning_of(points, at_.back());
  // A chord of no length has no slope; the curve is as good as constant there.
  const auto slope = [&](std::size_t i) {
    const double step = at_[i + 1] - at_[i];
    return step > 1e-14 * at_.back() ? 1.0 / (chords * step) : 0.0;
  };
  slopes_.assign(n + 1, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const double a = slope(i - 1);
    const double b = slope(i);
    slopes_[i] = a > 0 && b > 0 ? 2 * a * b / (a + b) : 0.0;
  }
  const auto end = [&](double near, double far) { return std::clamp(1.5 * near - 0.5 * far, 0.0, 3 * near); };
  slopes_[0] = end(slope(0), slopes_[1]);
  slopes_[n] = end(slope(n - 1), slopes_[n - 1]);
}

double ArcLength::parameter(double share) const {
  if (share <= 0) return 0;
  if (share >= 1) return 1;
  const double length = share * at_.back();
  const auto above = std::upper_bound(at_.begin(), at_.end() - 1, length);
  const auto i = static_cast<std::size_t>(above - at_.begin()) - 1;
  const double chords = static_cast<double>(at_.size() - 1);
  const double step = at_[i + 1] - at_[i];
  if (!(step > 0)) return static_cast<double>(i) / chords;
  const double x = (length - at_[i]) / step;
  const double y = 1 - x;
  const double bend = step * x * y * (slopes_[i] * y - slopes_[i + 1] * x);
  const double blend = x * x * (3 - 2 * x);
  return (static_cast<double>(i) + blend) / chords + bend;
}

}  // namespace isopatch::segmentation
