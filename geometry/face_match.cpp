#include "geometry/face_match.hpp"

#include <algorithm>
#include <limits>

#include "geometry/splines/grid.hpp"

namespace isopatch::geometry {
namespace {

constexpr double same_break = 1e-9;

std::array<FaceOrientation, 8> all_orientations() {
  std::array<FaceOrientation, 8> result;
  for (std::size_t i = 0; i < 8; ++i) result[i] = {(i & 4) != 0, (i & 1) != 0, (i & 2) != 0};
  return result;
}

std::vector<double> scaled_breaks(const KnotVector& knots, bool flip) {
  std::vector<double> result = knots.breaks();
  for (double& t : result)
    t = flip ? (knots.last() - t) / knots.length() : (t - knots.first()) / knots.length();
  return result;
}

// The ends of all spans of both directions and degree + 1 points on each of them, in [0, 1].
std::vector<double> samples(const KnotVector& mine, const KnotVector& other, bool flip) {
  std::vector<double> breaks = scaled_breaks(mine, false);
  const std::vector<double> more = scaled_breaks(other, flip);
  breaks.insert(breaks.end(), more.begin(), more.end());
  std::sort(breaks.begin(), breaks.end());
  const auto same = [](double a, double b) { return b - a < same_break; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
  const int intervals = std::max(mine.degree(), other.degree());
  std::vector<double> result = {0};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (int k = 1; k <= intervals; ++k)
      result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / intervals);
  result.back() = 1;
  return result;
}

std::vector<double> unscaled(const KnotVector& knots, std::vector<double> scaled, bool flip) {
  for (double& t : scaled) t = flip ? knots.last() - t * knots.length() : knots.first() + t * knots.length();
  return scaled;
}

double corner_distance(const NurbsSurface& first, const NurbsSurface& second,
                       const FaceOrientation& orientation) {
  double largest = 0;
  for (const double s : {0.0, 1.0})
    for (const double t : {0.0, 1.0}) {
      const Parameter<2> corner(s, t);
      const Eigen::Vector3d a = first.point(unscaled(first, corner));
      const Eigen::Vector3d b = second.point(unscaled(second, orientation(corner)));
      largest = std::max(largest, (a - b).norm());
    }
  return largest;
}

}  // namespace

Parameter<2> unscaled(const NurbsSurface& surface, const Parameter<2>& scaled) {
  return surface.low() + scaled.cwiseProduct(surface.high() - surface.low());
}

FaceMatch match_faces(const NurbsSurface& first, const NurbsSurface& second,
                      const FaceOrientation& orientation) {
  // Direction k of the first face is direction along[k] of the second.
  const std::array<int, 2> along = orientation.swapped ? std::array{1, 0} : std::array{0, 1};
  const std::array<bool, 2> flips = {orientation.flip_first, orientation.flip_second};
  std::array<std::vector<double>, 2> scaled;
  std::array<std::vector<double>, 2> on_first;
  std::array<std::vector<double>, 2> on_second;
  for (std::size_t k = 0; k < 2; ++k) {
    const KnotVector& mine = first.knots()[k];
    const auto a = static_cast<std::size_t>(along[k]);
    scaled[k] = samples(mine, second.knots()[a], flips[a]);
    on_first[k] = unscaled(mine, scaled[k], false);
    on_second[a] = unscaled(second.knots()[a], scaled[k], flips[a]);
  }
  const Eigen::Matrix3Xd points = points_on_grid(first, on_first);
  const Eigen::Matrix3Xd others = points_on_grid(second, on_second);
  const auto rows = static_cast<Eigen::Index>(scaled[0].size());
  const auto columns = static_cast<Eigen::Index>(scaled[1].size());
  FaceMatch match{orientation, -1, {}, {}, {}};
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Eigen::Vector3d point = points.col(i + j * rows);
      const Eigen::Vector3d other = others.col(orientation.swapped ? j + i * columns : i + j * rows);
      const double distance = (point - other).norm();
      if (distance <= match.distance) continue;
      match.distance = distance;
      match.parameter = {scaled[0][static_cast<std::size_t>(i)], scaled[1][static_cast<std::size_t>(j)]};
      match.first_point = point;
      match.second_point = other;
    }
  return match;
}

FaceMatch match_faces(const NurbsSurface& first, const NurbsSurface& second) {
  std::vector<std::pair<double, FaceOrientation>> by_corners;
  for (const FaceOrientation& orientation : all_orientations())
    by_corners.emplace_back(corner_distance(first, second, orientation), orientation);
  std::sort(by_corners.begin(), by_corners.end());
  FaceMatch best;
  best.distance = std::numeric_limits<double>::infinity();
  for (const auto& [at_corners, orientation] : by_corners) {
    if (at_corners >= best.distance) break;
    const FaceMatch match = match_faces(first, second, orientation);
    if (match.distance < best.distance) best = match;
  }
  return best;
}

}  // namespace isopatch::geometry
