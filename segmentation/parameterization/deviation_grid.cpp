#include "segmentation/parameterization/deviation_grid.hpp"

#include <algorithm>

namespace isopatch::segmentation {
namespace {

/// The interval that holds x, and how far x is in it, 0 to 1.
std::pair<Eigen::Index, double> interval(const std::vector<double>& points, double x) {
  const auto after = std::upper_bound(points.begin() + 1, points.end() - 1, x);
  const Eigen::Index i = after - points.begin() - 1;
  const double low = *(after - 1), high = *after;
  return {i, std::clamp((x - low) / (high - low), 0.0, 1.0)};
}

}  // namespace

double DeviationGrid::at(double x, double y) const {
  const auto [i, a] = interval(s, x);
  const auto [j, b] = interval(t, y);
  const auto n = static_cast<Eigen::Index>(s.size());
  const auto value = [&](Eigen::Index k, Eigen::Index l) { return values[k + n * l]; };
  return (1 - b) * ((1 - a) * value(i, j) + a * value(i + 1, j)) +
         b * ((1 - a) * value(i, j + 1) + a * value(i + 1, j + 1));
}

}  // namespace isopatch::segmentation
