#include "segmentation/parameterization/tests/checks.hpp"
#include "geometry/base/larger.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace isopatch::segmentation::test {
namespace {

double basis(const std::vector<double>& knots, std::size_t i, int degree, double t, double last) {
  if (degree == 0) {
    if (knots[i] <= t && t < knots[i + 1]) return 1;
    return t == last && knots[i] < last && knots[i + 1] == last ? 1 : 0;
  }
  const auto p = static_cast<std::size_t>(degree);
  double sum = 0;
  if (knots[i + p] > knots[i])
    sum += (t - knots[i]) / (knots[i + p] - knots[i]) * basis(knots, i, degree - 1, t, last);
  if (knots[i + p + 1] > knots[i + 1])
    sum +=
        (knots[i + p + 1] - t) / (knots[i + p + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, t, last);
  return sum;
}

double slope(const std::vector<double>& knots, std::size_t i, int degree, double t, double last) {
  const auto p = static_cast<std::size_t>(degree);
  double sum = 0;
  if (knots[i + p] > knots[i])
    sum += degree / (knots[i + p] - knots[i]) * basis(knots, i, degree - 1, t, last);
  if (knots[i + p + 1] > knots[i + 1])
    sum -= degree / (knots[i + p + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, t, last);
  return sum;
}

}  // namespace

ParameterizationOptions options(ParameterizationMethod method) {
  ParameterizationOptions result;
  result.method = method;
  return result;
}

int coincident_but_different_points(const geometry::PatchSet& set) {
  struct Point {
    Eigen::Vector3d at;
    std::size_t patch;
  };
  std::vector<Point> points;
  Eigen::Vector3d low = set.patches[0].control_points().col(0), high = low;
  for (std::size_t p = 0; p < set.patches.size(); ++p)
    for (const auto& point : set.patches[p].control_points().colwise()) {
      points.push_back({point, p});
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  const double near = 1e-6 * (high - low).norm();
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.at[0] < b.at[0]; });
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size() && points[j].at[0] - points[i].at[0] < near; ++j)
      if (points[i].patch != points[j].patch && (points[i].at - points[j].at).norm() < near &&
          points[i].at != points[j].at)
        ++count;
  return count;
}

double plain_determinant(const geometry::NurbsVolume& volume, const Eigen::Vector3d& parameter) {
  std::array<std::vector<double>, 3> values, slopes;
  for (int d = 0; d < 3; ++d)
    for (int i = 0; i < volume.size(d); ++i) {
      const auto& knots = volume.knots(d).knots();
      const auto at = static_cast<std::size_t>(i);
      values[static_cast<std::size_t>(d)].push_back(
          basis(knots, at, volume.degree(d), parameter[d], knots.back()));
      slopes[static_cast<std::size_t>(d)].push_back(
          slope(knots, at, volume.degree(d), parameter[d], knots.back()));
    }
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < values[2].size(); ++k)
    for (std::size_t j = 0; j < values[1].size(); ++j)
      for (std::size_t i = 0; i < values[0].size(); ++i, ++column) {
        const Eigen::Vector3d point = volume.control_points().col(column);
        jacobian.col(0) += slopes[0][i] * values[1][j] * values[2][k] * point;
        jacobian.col(1) += values[0][i] * slopes[1][j] * values[2][k] * point;
        jacobian.col(2) += values[0][i] * values[1][j] * slopes[2][k] * point;
      }
  return jacobian.determinant();
}

double smallest_determinant(const geometry::NurbsVolume& volume, int n) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        smallest = smaller(smallest, plain_determinant(volume, Eigen::Vector3d(i, j, k) / (n - 1)));
  return smallest;
}

}  // namespace isopatch::segmentation::test
