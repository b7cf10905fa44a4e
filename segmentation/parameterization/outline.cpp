#include "segmentation/parameterization/internal/outline.hpp"

#include <algorithm>

namespace isopatch::segmentation {

Eigen::Vector2d coons_point(const std::array<DomainCurve, 4>& sides, double s, double t) {
  const Eigen::Vector2d a = sides[0](0), b = sides[0](1), c = sides[1](0), d = sides[1](1);
  return (1 - t) * sides[0](s) + t * sides[1](s) + (1 - s) * sides[2](t) + s * sides[3](t) -
         (1 - t) * ((1 - s) * a + s * b) - t * ((1 - s) * c + s * d);
}

double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  return u[0] * v[1] - u[1] * v[0];
}

std::optional<Eigen::Vector2d> self_intersection(const std::vector<DomainCurve>& loop) {
  constexpr int chords = 24;
  std::vector<Eigen::Vector2d> points;
  for (const DomainCurve& curve : loop)
    for (int i = 0; i < chords; ++i) points.push_back(curve(double(i) / chords));
  const std::size_t n = points.size();
  double longest = 0;
  for (std::size_t i = 0; i < n; ++i) longest = std::max(longest, (points[i] - points[0]).squaredNorm());
  // Chords of one straight side are not exactly on one line.
  const double clear = 1e-12 * longest;
  const auto apart = [&](double x, double y) { return std::min(x, y) < -clear && std::max(x, y) > clear; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const auto &a = points[i], &b = points[i + 1], &c = points[j], &d = points[(j + 1) % n];
      const double c_side = doubled_area(a, b, c), d_side = doubled_area(a, b, d);
      const double a_side = doubled_area(c, d, a), b_side = doubled_area(c, d, b);
      if (apart(c_side, d_side) && apart(a_side, b_side)) return a + (b - a) * (a_side / (a_side - b_side));
    }
  return std::nullopt;
}

}  // namespace isopatch::segmentation
