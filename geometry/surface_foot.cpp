#include "geometry/surface_foot.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/splines/grid.hpp"

namespace isopatch::geometry {
namespace {

// degree + 1 points on each element, ends included.
std::vector<double> start_parameters(const KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<double> result = {breaks.front()};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (int k = 1; k <= knots.degree(); ++k)
      result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / knots.degree());
  return result;
}

// The step of parameters that goes nearest to a step in space.
Parameter<2> parameter_step(const Eigen::Matrix<double, 3, 2>& tangents, const Eigen::Vector3d& step) {
  Eigen::Matrix2d normal = tangents.transpose() * tangents;
  normal.diagonal().array() += 1e-12 * normal.trace() + std::numeric_limits<double>::min();
  return normal.inverse() * (tangents.transpose() * step);
}

}  // namespace

SurfaceFoot surface_foot(const NurbsSurface& surface, const Eigen::Vector3d& point, Parameter<2> start) {
  SurfaceFoot best{start, std::numeric_limits<double>::infinity()};
  for (int step = 0; step < 20; ++step) {
    const Eigen::Vector3d away = point - surface.point(start);
    const double distance = away.norm();
    if (!(distance < 0.999 * best.distance)) break;
    best = {start, distance};
    start += parameter_step(surface.jacobian(start), away);
    start = start.cwiseMax(surface.low()).cwiseMin(surface.high());
  }
  return best;
}

SurfaceFoot surface_foot(const NurbsSurface& surface, const Eigen::Vector3d& point, double enough) {
  const GridParameters<2> grid = {start_parameters(surface.knots(0)), start_parameters(surface.knots(1))};
  const Eigen::Matrix3Xd points = points_on_grid(surface, grid);
  std::vector<std::pair<double, Eigen::Index>> nearest;
  for (Eigen::Index i = 0; i < points.cols(); ++i) nearest.emplace_back((points.col(i) - point).norm(), i);
  const std::size_t starts = std::min<std::size_t>(3, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(starts), nearest.end());
  const auto start_of = [&](std::size_t k) {
    const auto i = static_cast<std::size_t>(nearest[k].second);
    return Parameter<2>(grid[0][i % grid[0].size()], grid[1][i / grid[0].size()]);
  };
  SurfaceFoot best{start_of(0), nearest.front().first};
  for (std::size_t k = 0; k < starts && best.distance > enough; ++k) {
    const SurfaceFoot foot = surface_foot(surface, point, start_of(k));
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

Parameter<2> continued_parameter(const NurbsSurface& surface, const Eigen::Vector3d& point,
                                 const SurfaceFoot& foot) {
  return foot.parameter +
         parameter_step(surface.jacobian(foot.parameter), point - surface.point(foot.parameter));
}

}  // namespace isopatch::geometry
