#include "segmentation/parameterization/internal/spline_fit.hpp"

#include <algorithm>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/tensor.hpp"

namespace isopatch::segmentation {
namespace {

Eigen::MatrixXd dense_collocation(const KnotVector& knots, const std::vector<double>& parameters) {
  return Eigen::MatrixXd(geometry::collocation(knots, parameters));
}

}  // namespace

std::vector<double> fitting_parameters(const KnotVector& knots, int per_span) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<double> result{breaks.front()};
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    for (int i = 0; i < per_span; ++i)
      result.push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * (i + 0.5) / per_span);
  result.push_back(breaks.back());
  return result;
}

Eigen::MatrixXd inner_fit(const KnotVector& knots, const std::vector<double>& parameters) {
  const Eigen::MatrixXd all = dense_collocation(knots, parameters);
  if (all.cols() <= 2) return Eigen::MatrixXd(0, all.rows());
  return pseudo_inverse(all.middleCols(1, all.cols() - 2));
}

Eigen::Matrix3Xd fit_curve(const KnotVector& knots, const std::vector<double>& parameters,
                           const Eigen::Matrix3Xd& points, const Eigen::Vector3d& first,
                           const Eigen::Vector3d& last) {
  const Eigen::MatrixXd basis = dense_collocation(knots, parameters);
  const std::vector<double> greville = knots.greville();
  Eigen::Matrix3Xd result(3, knots.size());
  for (int i = 0; i < knots.size(); ++i) {
    const double share = (greville[static_cast<std::size_t>(i)] - knots.first()) / knots.length();
    result.col(i) = (1 - share) * first + share * last;
  }
  result.rightCols(1) = last;
  const Eigen::Matrix3Xd rest = points - result * basis.transpose();
  if (knots.size() > 2)
    result.middleCols(1, knots.size() - 2) += rest * inner_fit(knots, parameters).transpose();
  return result;
}

Eigen::Matrix3Xd fit_surface(const std::array<KnotVector, 2>& knots,
                             const std::array<std::vector<double>, 2>& parameters,
                             const Eigen::Matrix3Xd& points, Eigen::Matrix3Xd boundary) {
  const std::array<int, 2> sizes{knots[0].size(), knots[1].size()};
  if (sizes[0] < 3 || sizes[1] < 3) return boundary;
  Eigen::Matrix3Xd values = boundary;
  std::array<int, 2> grid = sizes;
  for (std::size_t d = 0; d < 2; ++d) {
    values = geometry::apply_along<2>(values, grid, static_cast<int>(d),
                                      dense_collocation(knots[d], parameters[d]));
    grid[d] = static_cast<int>(parameters[d].size());
  }
  Eigen::Matrix3Xd correction = points - values;
  for (std::size_t d = 0; d < 2; ++d) {
    correction =
        geometry::apply_along<2>(correction, grid, static_cast<int>(d), inner_fit(knots[d], parameters[d]));
    grid[d] = sizes[d] - 2;
  }
  for (int j = 1; j + 1 < sizes[1]; ++j)
    boundary.middleCols(j * sizes[0] + 1, sizes[0] - 2) += correction.middleCols((j - 1) * grid[0], grid[0]);
  return boundary;
}

RationalNet fit_surface(const std::array<KnotVector, 2>& knots,
                        const std::array<std::vector<double>, 2>& parameters, const Eigen::Matrix3Xd& points,
                        RationalNet boundary) {
  if (!boundary.is_rational())
    return RationalNet::polynomial(fit_surface(knots, parameters, points, std::move(boundary.points)));
  // Weighted points are fitted by weighted coefficients, of which the weights themselves are known.
  Eigen::Matrix3Xd weights = boundary.weights.transpose().replicate(3, 1);
  std::array<int, 2> grid{knots[0].size(), knots[1].size()};
  for (std::size_t d = 0; d < 2; ++d) {
    weights = geometry::apply_along<2>(weights, grid, static_cast<int>(d),
                                       dense_collocation(knots[d], parameters[d]));
    grid[d] = static_cast<int>(parameters[d].size());
  }
  const Eigen::Matrix3Xd found = fit_surface(knots, parameters, points.cwiseProduct(weights),
                                             boundary.points * boundary.weights.asDiagonal());
  const int n = knots[0].size(), m = knots[1].size();
  for (int j = 1; j + 1 < m; ++j)
    for (int i = 1; i + 1 < n; ++i)
      boundary.points.col(i + n * j) = found.col(i + n * j) / boundary.weights[i + n * j];
  return boundary;
}

std::vector<double> line_errors(const std::array<KnotVector, 2>& knots,
                                const std::array<std::vector<double>, 2>& parameters,
                                const Eigen::Matrix3Xd& points, int direction) {
  const auto d = static_cast<std::size_t>(direction);
  const Eigen::MatrixXd basis = dense_collocation(knots[d], parameters[d]);
  const std::array<int, 2> grid{static_cast<int>(parameters[0].size()),
                                static_cast<int>(parameters[1].size())};
  const Eigen::MatrixXd projector = basis * pseudo_inverse(basis);
  const Eigen::Matrix3Xd rest = points - geometry::apply_along<2>(points, grid, direction, projector);
  const std::vector<double> breaks = knots[d].breaks();
  std::vector<double> result(breaks.size() - 1, 0.0);
  for (Eigen::Index k = 0; k < rest.cols(); ++k) {
    const auto index = static_cast<std::size_t>(d == 0 ? k % grid[0] : k / grid[0]);
    const auto above = std::upper_bound(breaks.begin(), breaks.end(), parameters[d][index]);
    const auto span =
        std::min<std::size_t>(static_cast<std::size_t>(above - breaks.begin()) - 1, result.size() - 1);
    result[span] = std::max(result[span], rest.col(k).norm());
  }
  return result;
}

}  // namespace isopatch::segmentation
