#include "segmentation/reconstruction/internal/steady_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isopatch::segmentation {
namespace {

// Points of a curve for each vertex of its polygon or control point.
constexpr int points_for_each = 8;

Eigen::Vector3d way(const Eigen::Matrix3Xd& points, Eigen::Index i) {
  return points.col(i + 1) - points.col(i);
}

/// By which a polygon turns at a vertex, rad: at its ends as at the vertices next to them, if it has such.
double turn(const Eigen::Matrix3Xd& polygon, Eigen::Index i) {
  const Eigen::Index last = polygon.cols() - 1;
  if (last < 2) return 0;
  const Eigen::Index inner = std::clamp<Eigen::Index>(i, 1, last - 1);
  const Eigen::Vector3d before = way(polygon, inner - 1), after = way(polygon, inner);
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

/// Length of arcs over a polygon's sides, each of which turns as its ends do: by half of what these turn by
/// each.
double length_of_arcs(const Eigen::Matrix3Xd& polygon) {
  double result = 0;
  for (Eigen::Index i = 0; i + 1 < polygon.cols(); ++i) {
    const double half = (turn(polygon, i) + turn(polygon, i + 1)) / 4;
    result += way(polygon, i).norm() * (half > 0 ? half / std::sin(half) : 1);
  }
  return result;
}

struct NearestSide {
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d along;
};

NearestSide nearest_side(const Eigen::Vector3d& point, const Eigen::Matrix3Xd& polygon) {
  NearestSide result;
  for (Eigen::Index k = 0; k + 1 < polygon.cols(); ++k) {
    const Eigen::Vector3d side = way(polygon, k), arm = point - polygon.col(k);
    const double share = std::clamp(arm.dot(side) / side.squaredNorm(), 0.0, 1.0);
    const double distance = (arm - share * side).norm();
    if (distance < result.distance) result = {distance, side};
  }
  return result;
}

int samples_of(const geometry::NurbsCurve& curve, const Eigen::Matrix3Xd& polygon) {
  return points_for_each * static_cast<int>(std::max<Eigen::Index>(polygon.cols(), curve.size()));
}

geometry::Parameter<1> sample(const geometry::NurbsCurve& curve, int i, int count) {
  return curve.low() + (curve.high() - curve.low()) * i / count;
}

/// Whether a curve turns against the polygon of its points.
bool runs_back(const geometry::NurbsCurve& curve, const Eigen::Matrix3Xd& polygon) {
  const int count = samples_of(curve, polygon);
  for (int i = 0; i <= count; ++i) {
    const geometry::Parameter<1> at = sample(curve, i, count);
    if (!(curve.derivative(at, {1}).dot(nearest_side(curve.point(at), polygon).along) > 0)) return true;
  }
  return false;
}

}  // namespace

double length_of(const Eigen::Matrix3Xd& points) {
  return (points.rightCols(points.cols() - 1) - points.leftCols(points.cols() - 1)).colwise().norm().sum();
}

double waviness(const Eigen::Matrix3Xd& line, const Eigen::Matrix3Xd& polygon) {
  return length_of(line) / length_of_arcs(polygon);
}

double farthest(const geometry::NurbsCurve& curve, const Eigen::Matrix3Xd& polygon) {
  double result = 0;
  for (int i = 0, count = samples_of(curve, polygon); i <= count; ++i)
    result = std::max(result, nearest_side(curve.point(sample(curve, i, count)), polygon).distance);
  return result;
}

bool is_steady(const geometry::NurbsCurve& curve, const Eigen::Matrix3Xd& polygon) {
  const int count = samples_of(curve, polygon);
  Eigen::Matrix3Xd line(3, count + 1);
  for (int i = 0; i <= count; ++i) line.col(i) = curve.point(sample(curve, i, count));
  return waviness(line, polygon) < most_waviness && !runs_back(curve, polygon);
}

}  // namespace isopatch::segmentation
