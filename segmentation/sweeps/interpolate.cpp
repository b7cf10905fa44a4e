#include "segmentation/sweeps/interpolate.hpp"

#include <utility>
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

geometry::NurbsCurve through_points_of(const std::function<Eigen::Vector3d(double)>& curve,
                                       const geometry::KnotVector& knots) {
  const std::vector<double> at = knots.greville();
  Eigen::MatrixXd points(static_cast<Eigen::Index>(at.size()), 3);
  for (std::size_t i = 0; i < at.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = curve(at[i]);
  return geometry::NurbsCurve({knots}, through(knots, points).transpose());
}

geometry::KnotVector knots_at(const std::vector<double>& breaks) {
  std::vector<double> knots(degree_between, breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), degree_between, breaks.back());
  return {degree_between, knots};
}

bool is_close(const geometry::NurbsCurve& made, const std::function<Eigen::Vector3d(double)>& curve,
              double low, double high, double tolerance) {
  constexpr int places = 4;  // none of the points
  for (int i = 0; i < places; ++i) {
    const double t = low + (high - low) * (i + 0.37) / places;
    if (!((made.point(geometry::Parameter<1>(t)) - curve(t)).norm() <= tolerance)) return false;
  }
  return true;
}

}  // namespace

geometry::NurbsCurve interpolated(const std::function<Eigen::Vector3d(double)>& curve) {
  return through_points_of(curve, geometry::KnotVector::uniform(degree_between, spans_between));
}

geometry::NurbsCurve interpolated(const std::function<Eigen::Vector3d(double)>& curve, double tolerance) {
  std::vector<double> breaks;
  for (int i = 0; i <= spans_between; ++i) breaks.push_back(static_cast<double>(i) / spans_between);
  constexpr int most_halvings = 20;
  for (int halvings = 0; halvings <= most_halvings; ++halvings) {
    geometry::NurbsCurve made = through_points_of(curve, knots_at(breaks));
    std::vector<double> finer = {0};
    for (std::size_t i = 1; i < breaks.size(); ++i) {
      if (!is_close(made, curve, breaks[i - 1], breaks[i], tolerance))
        finer.push_back((breaks[i - 1] + breaks[i]) / 2);
      finer.push_back(breaks[i]);
    }
    if (finer.size() == breaks.size()) return made;
    breaks = std::move(finer);
  }
  throw Error(ErrorCode::unsupported, "a curve of the solid has corners");
}

geometry::NurbsSurface interpolated(const std::function<Eigen::Vector3d(double, double)>& surface,
                                    int spans) {
  const auto knots = geometry::KnotVector::uniform(degree_between, spans);
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
