#include "segmentation/sweeps/interpolate.hpp"

#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/sparse_lu.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::segmentation {
namespace {

constexpr int degree_between = 5, spans_between = 8;

/// Control points, in rows, of splines through points, in rows.
Eigen::MatrixXd through(const geometry::KnotVector& knots, const Eigen::MatrixXd& points) {
  const Eigen::SparseMatrix<double> matrix = geometry::collocation(knots, knots.greville());
  const auto result = solve_by_lu(matrix, points);
  if (!result) throw Error(ErrorCode::internal, "a spline has no control points for its own points");
  return *result;
}

}  // namespace

geometry::NurbsCurve interpolated(const std::function<Eigen::Vector3d(double)>& curve) {
  const auto knots = geometry::KnotVector::uniform(degree_between, spans_between);
  const std::vector<double> at = knots.greville();
  Eigen::MatrixXd points(static_cast<Eigen::Index>(at.size()), 3);
  for (std::size_t i = 0; i < at.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = curve(at[i]);
  return geometry::NurbsCurve({knots}, through(knots, points).transpose());
}

geometry::NurbsSurface interpolated(const std::function<Eigen::Vector3d(double, double)>& surface) {
  const auto knots = geometry::KnotVector::uniform(degree_between, spans_between);
  const std::vector<double> at = knots.greville();
  const auto n = static_cast<Eigen::Index>(at.size());
  // One row for each u, all v side by side; then the other way round.
  Eigen::MatrixXd points(n, 3 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      points.block<1, 3>(i, 3 * j) =
          surface(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]).transpose();
  const Eigen::MatrixXd along = through(knots, points);
  Eigen::MatrixXd turned(n, 3 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) turned.block<1, 3>(j, 3 * i) = along.block<1, 3>(i, 3 * j);
  const Eigen::MatrixXd net = through(knots, turned);
  Eigen::Matrix3Xd result(3, n * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) result.col(i + n * j) = net.block<1, 3>(j, 3 * i).transpose();
  return geometry::NurbsSurface({knots, knots}, result);
}

}  // namespace isopatch::segmentation
