#include "iga/estimate/internal/held_places.hpp"

#include <algorithm>
#include <cmath>

namespace isopatch::iga {
namespace {

// The longest extent of the element at a place, m.
double element_extent(const geometry::NurbsVolume& patch, const geometry::Parameter<3>& parameter) {
  const Eigen::Matrix3d jacobian = patch.jacobian(parameter);
  double result = 0;
  for (int d = 0; d < 3; ++d) {
    const auto span = static_cast<std::size_t>(patch.knots(d).span(parameter[d]));
    const auto& knots = patch.knots(d).knots();
    result = std::max(result, jacobian.col(d).norm() * (knots[span + 1] - knots[span]));
  }
  return result;
}

bool is_on(const geometry::NurbsVolume& patch, const geometry::Parameter<3>& parameter, geometry::Side side,
           double within) {
  const int d = geometry::direction(side);
  const double end = geometry::is_high(side) ? patch.high()[d] : patch.low()[d];
  return patch.jacobian(parameter).col(d).norm() * std::abs(parameter[d] - end) <= within;
}

bool is_at_rim(const Region& region, const Eigen::Vector3d& point, double within) {
  const auto& bounds = region.bounds;
  return std::any_of(bounds.begin(), bounds.end(),
                     [&](const Quadric& bound) { return std::abs(bound.at(point)) <= within; }) &&
         std::all_of(bounds.begin(), bounds.end(),
                     [&](const Quadric& bound) { return bound.at(point) >= -within; });
}

bool is_near(const std::vector<PatchPoint>& points, const Discretization& d, const Eigen::Vector3d& place,
             double within) {
  return std::any_of(points.begin(), points.end(), [&](const PatchPoint& point) {
    const auto p = static_cast<std::size_t>(point.patch.value);
    return (d.patches[p].point(point.parameter) - place).norm() <= within;
  });
}

}  // namespace

std::optional<std::string> why_held_singular(const ElasticityProblem& problem, const PatchPlace& place) {
  const Discretization& d = problem.discretization;
  const geometry::NurbsVolume& patch = d.patches[static_cast<std::size_t>(place.patch)];
  const Eigen::Vector3d point = patch.point(place.parameter);
  const double element = element_extent(patch, place.parameter);
  for (const Support& support : problem.supports) {
    if (is_near(support.points, d, point, element)) return "a point that is held";
    if (support.region.is_everywhere() || std::holds_alternative<ElasticSupport>(support.condition)) continue;
    for (const geometry::PatchFace& face : support.faces)
      if (face.patch.value == place.patch && is_on(patch, place.parameter, face.side, 0.25 * element) &&
          is_at_rim(support.region, point, 0.25 * element))
        return "the rim of a part that is held";
  }
  for (const PointLoad& load : problem.point_loads)
    if (is_near(load.points, d, point, element)) return "a point that is loaded";
  return std::nullopt;
}

}  // namespace isopatch::iga
