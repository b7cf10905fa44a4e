#include "segmentation/parameterization/internal/face_contact.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace isopatch::segmentation {
namespace {

using geometry::FaceOrientation;
using geometry::Parameter;

Parameter<2> clamped(const Parameter<2>& p) {
  return p.cwiseMax(0.0).cwiseMin(1.0);
}

// Gauss-Newton on the face map, kept in the unit square.
FaceFoot refined_foot(const FaceMap& face, const Eigen::Vector3d& point, Parameter<2> at) {
  constexpr double step = 1e-5;
  double best = (face.point(at[0], at[1]) - point).norm();
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d here = face.point(at[0], at[1]);
    Eigen::Matrix<double, 3, 2> slopes;
    for (int d = 0; d < 2; ++d) {
      const double h = at[d] > 0.5 ? -step : step;
      const Parameter<2> beside = at + h * Parameter<2>::Unit(d);
      slopes.col(d) = (face.point(beside[0], beside[1]) - here) / h;
    }
    const Eigen::Matrix2d normal = slopes.transpose() * slopes;
    if (!(std::abs(normal.determinant()) > 0)) break;
    const Parameter<2> next = clamped(at + normal.inverse() * slopes.transpose() * (point - here));
    const double distance = (face.point(next[0], next[1]) - point).norm();
    if (!(distance < best * (1 - 1e-6))) break;
    best = distance;
    at = next;
  }
  return {at, best};
}

std::vector<FaceOrientation> orientations() {
  std::vector<FaceOrientation> result;
  for (int i = 0; i < 8; ++i) result.push_back({(i & 1) != 0, (i & 2) != 0, (i & 4) != 0});
  return result;
}

const std::vector<double>& coarse() {
  static const std::vector<double> at = [] {
    std::vector<double> steps;
    for (int i = 0; i <= 12; ++i) steps.push_back(i / 12.0);
    return steps;
  }();
  return at;
}

}  // namespace

FaceFoot foot(const FaceMap& face, const Eigen::Vector3d& point, double reach) {
  const Eigen::Matrix3Xd grid = face.grid(coarse(), coarse());
  Eigen::Index nearest = 0;
  const double found = (grid.colwise() - point).colwise().norm().minCoeff(&nearest);
  const auto n = static_cast<Eigen::Index>(coarse().size());
  double cell = 0;
  for (Eigen::Index k = 0; k + n + 1 < grid.cols(); ++k)
    cell = std::max(cell, (grid.col(k + n + 1) - grid.col(k)).norm());
  const Parameter<2> start(coarse()[static_cast<std::size_t>(nearest % n)],
                           coarse()[static_cast<std::size_t>(nearest / n)]);
  if (found > reach + 2 * cell) return {start, found};
  return refined_foot(face, point, start);
}

FaceContact contact(const FaceMap& first, const FaceMap& second) {
  FaceContact best;
  best.distance = std::numeric_limits<double>::infinity();
  for (const FaceOrientation& orientation : orientations()) {
    FaceContact here{orientation, 0, Eigen::Vector3d::Zero()};
    const auto compare = [&](double s, double t) {
      const Parameter<2> other = orientation(Parameter<2>(s, t));
      const Eigen::Vector3d point = first.point(s, t);
      const double distance = (point - second.point(other[0], other[1])).norm();
      if (distance < here.distance) return;
      here.distance = distance;
      here.place = point;
    };
    for (const double s : {0.0, 1.0})
      for (const double t : {0.0, 1.0}) compare(s, t);
    if (here.distance < best.distance) best = here;
  }
  const auto compare_side = [&](double s, double t) {
    const Parameter<2> other = best.orientation(Parameter<2>(s, t));
    const Eigen::Vector3d point = first.point(s, t);
    const double distance = (point - second.point(other[0], other[1])).norm();
    if (distance > best.distance) {
      best.distance = distance;
      best.place = point;
    }
  };
  for (const double x : {0.125, 0.3, 0.5, 0.7, 0.875})
    for (const double end : {0.0, 1.0}) {
      compare_side(x, end);
      compare_side(end, x);
    }
  for (const double s : {0.2, 0.5, 0.8})
    for (const double t : {0.2, 0.5, 0.8}) {
      const Eigen::Vector3d point = first.point(s, t);
      const double away = refined_foot(second, point, best.orientation(Parameter<2>(s, t))).distance;
      if (away > best.distance) {
        best.distance = away;
        best.place = point;
      }
    }
  return best;
}

}  // namespace isopatch::segmentation
