#include "segmentation/reconstruction/internal/nearest_on_spline.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <utility>
#include <vector>

namespace isopatch::segmentation {
namespace {

// Points of the grid in each span.
constexpr int places_of_span = 3;
constexpr int most_halved_steps = 4;

std::vector<double> grid_of(const geometry::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<double> result;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    for (int i = 0; i < places_of_span; ++i)
      result.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * (i + 0.5) / places_of_span);
  return result;
}

}  // namespace

NearestOnSpline::NearestOnSpline(geometry::NurbsSurface surface) : surface_(std::move(surface)) {
  const std::vector<double> us = grid_of(surface_.knots(0)), vs = grid_of(surface_.knots(1));
  places_.resize(2, static_cast<Eigen::Index>(us.size() * vs.size()));
  points_.resize(3, places_.cols());
  Eigen::Index at = 0;
  for (const double v : vs)
    for (const double u : us) {
      places_.col(at) = Eigen::Vector2d(u, v);
      points_.col(at) = surface_.point(places_.col(at));
      ++at;
    }
}

Eigen::Vector2d NearestOnSpline::parameters(const Eigen::Vector3d& point) const {
  Eigen::Index nearest = 0;
  (points_.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
  return parameters(point, places_.col(nearest));
}

Eigen::Vector2d NearestOnSpline::parameters(const Eigen::Vector3d& point,
                                            const Eigen::Vector2d& start) const {
  const Eigen::Vector2d low = surface_.low(), high = surface_.high();
  Eigen::Vector2d uv = start.cwiseMax(low).cwiseMin(high);
  for (int round = 0; round < 30; ++round) {
    const Eigen::Matrix<double, 3, 2> slopes = surface_.jacobian(uv);
    const Eigen::Matrix2d matrix = slopes.transpose() * slopes;
    Eigen::Vector2d step = matrix.ldlt().solve(slopes.transpose() * (point - surface_.point(uv)));
    // Held at a border, only the other parameter is free.
    for (Eigen::Index i = 0; i < 2; ++i)
      if ((uv[i] == low[i] && step[i] < 0) || (uv[i] == high[i] && step[i] > 0)) {
        step[i] = 0;
        step[1 - i] = slopes.col(1 - i).dot(point - surface_.point(uv)) / matrix(1 - i, 1 - i);
      }
    Eigen::Vector2d next = (uv + step).cwiseMax(low).cwiseMin(high);
    // Where the surface bends away, the whole step leads too far.
    const double before = (point - surface_.point(uv)).norm();
    for (int half = 0; half < most_halved_steps && (point - surface_.point(next)).norm() > before; ++half)
      next = (uv + (step *= 0.5)).cwiseMax(low).cwiseMin(high);
    const bool done = !((next - uv).norm() > 1e-12 * (high - low).norm());
    uv = next;
    if (done) break;
  }
  return uv;
}

CarrierDistance NearestOnSpline::distance(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d uv = parameters(point);
  const Eigen::Matrix<double, 3, 2> slopes = surface_.jacobian(uv);
  const Eigen::Vector3d normal = slopes.col(0).cross(slopes.col(1)).normalized();
  const Eigen::Vector3d way = point - surface_.point(uv);
  const double length = way.norm();
  return {way.dot(normal) < 0 ? -length : length, normal, 0, 0};
}

}  // namespace isopatch::segmentation
