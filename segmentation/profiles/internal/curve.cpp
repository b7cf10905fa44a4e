#include "segmentation/profiles/internal/curve.hpp"

#include <algorithm>
#include <cmath>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;

namespace {

double cross_of(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The points with two more at each end: around a closed curve, else on the cubic (parabola) through the last
/// ones.
std::vector<Vector2d> prolonged(const std::vector<Vector2d>& points, bool closed) {
  const int n = static_cast<int>(points.size());
  std::vector<Vector2d> result = points;
  const auto before = [](const Vector2d& a, const Vector2d& b, const Vector2d& c,
                         const Vector2d* d) -> Vector2d {
    return d ? Vector2d(4 * a - 6 * b + 4 * c - *d) : Vector2d(3 * a - 3 * b + c);
  };
  for (int step = 0; step < 2; ++step) {
    Vector2d first, last;
    if (closed) {
      first = points[n - 2 - step];
      last = points[1 + step];
    } else {
      const int m = static_cast<int>(result.size());
      const bool cubic = n > 3;
      first = before(result[0], result[1], result[2], cubic ? &result[3] : nullptr);
      last = before(result[m - 1], result[m - 2], result[m - 3], cubic ? &result[m - 4] : nullptr);
    }
    result.insert(result.begin(), first);
    result.push_back(last);
  }
  return result;
}

std::vector<Vector2d> derivatives_at(const std::vector<Vector2d>& points, bool closed) {
  if (points.size() == 2) return std::vector<Vector2d>(2, points[1] - points[0]);
  const std::vector<Vector2d> all = prolonged(points, closed);
  std::vector<Vector2d> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result[i] = (8 * (all[i + 3] - all[i + 1]) - (all[i + 4] - all[i])) / 12;
  return result;
}

}  // namespace

Curve::Curve(const ProfileEdge& edge)
    : closed_(edge.start < 0),
      points_(edge.points),
      derivatives_(derivatives_at(edge.points, edge.start < 0)) {
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) length_ += (points_[i + 1] - points_[i]).norm();
  for (std::size_t i = 0; i + 1 < points_.size() && !straight(); ++i)
    turning_ += std::abs(
        std::atan2(cross_of(derivatives_[i], derivatives_[i + 1]), derivatives_[i].dot(derivatives_[i + 1])));
}

Curve::Place Curve::place(double parameter) const {
  const int pieces = static_cast<int>(points_.size()) - 1;
  if (closed_) parameter -= std::floor(parameter);
  const double at = std::clamp(parameter, 0.0, 1.0) * pieces;
  const int piece = std::min(static_cast<int>(at), pieces - 1);
  return {piece, at - piece};
}

Vector2d Curve::at(double parameter) const {
  const auto [i, t] = place(parameter);
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * points_[i] + t * t * (1 + 2 * s) * points_[i + 1] +
         s * t * (s * derivatives_[i] - t * derivatives_[i + 1]);
}

Vector2d Curve::derivative(double parameter) const {
  const auto [i, t] = place(parameter);
  const double s = 1 - t;
  const Vector2d step = 6 * s * t * (points_[i + 1] - points_[i]) + s * (s - 2 * t) * derivatives_[i] +
                        t * (t - 2 * s) * derivatives_[i + 1];
  return step * static_cast<double>(points_.size() - 1);
}

double Curve::nearest(const Vector2d& point, double low, double high) const {
  constexpr int samples = 32;
  const auto distance = [&](double t) { return (at(t) - point).squaredNorm(); };
  double best = low, step = (high - low) / samples;
  for (int i = 1; i <= samples; ++i)
    if (distance(low + i * step) < distance(best)) best = low + i * step;
  for (; step > 1e-10; step /= 2)
    for (const double t : {best - step, best + step})
      if (t >= low && t <= high && distance(t) < distance(best)) best = t;
  return best;
}

std::vector<Curve> curves_of(const Profile& profile) {
  std::vector<Curve> result;
  for (const ProfileEdge& edge : profile.edges) result.emplace_back(edge);
  return result;
}

}  // namespace isopatch::segmentation::planar
