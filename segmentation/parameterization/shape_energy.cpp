#include "segmentation/parameterization/internal/shape_energy.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/splines/grid.hpp"
#include "geometry/splines/tensor.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::KnotVector;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Lobatto's rule, so that the ends of spans are among the nodes, where folds begin: four points a span, three
// where spans are many.
void add_nodes(const KnotVector& knots, std::vector<std::pair<double, double>>& nodes) {
  const double inner = (1 - 1 / std::sqrt(5.0)) / 2;
  const std::vector<double> breaks = knots.breaks();
  constexpr std::size_t many = 4;
  const std::vector<std::pair<double, double>> rule =
      breaks.size() > many
          ? std::vector<std::pair<double, double>>{{0.0, 1.0 / 6}, {0.5, 4.0 / 6}, {1.0, 1.0 / 6}}
          : std::vector<std::pair<double, double>>{
                {0.0, 1.0 / 12}, {inner, 5.0 / 12}, {1 - inner, 5.0 / 12}, {1.0, 1.0 / 12}};
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) {
    const double a = breaks[e], h = breaks[e + 1] - breaks[e];
    for (const auto& [x, w] : rule) nodes.emplace_back(x == 1 ? breaks[e + 1] : a + x * h, w * h);
  }
}

bool at_end(const std::vector<double>& nodes, std::size_t i) {
  return i == 0 || i + 1 == nodes.size();
}

struct Integrand {
  double value = 0;
  double determinant = 0;
  Eigen::Matrix3d slope;  ///< by the entries of M
};

Integrand integrand(const Eigen::Matrix3d& m, double epsilon) {
  constexpr double size_weight = 1.0 / 8;
  Integrand result;
  const double d = m.determinant();
  const double root = std::sqrt(epsilon * epsilon + d * d);
  // Without cancellation for negative determinants.
  const double chi = d > 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d));
  const double chi_slope = chi / root;
  const double square = m.squaredNorm();
  const double scale = 1 / (3 * std::cbrt(chi * chi));
  const double size = size_weight / chi;
  Eigen::Matrix3d cofactors;
  cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
  result.determinant = d;
  result.value = square * scale + size * (d * d + 1);
  const double by_determinant =
      -2.0 / 3 * square * scale / chi * chi_slope + size * (2 * d - (d * d + 1) / chi * chi_slope);
  result.slope = 2 * scale * m + by_determinant * cofactors;
  return result;
}

}  // namespace

ShapeEnergy::ShapeEnergy(const std::array<KnotVector, 3>& knots, const Eigen::Vector3d& lengths,
                         CountedPoints counted, const std::array<std::vector<double>, 3>& extra,
                         const Eigen::VectorXd& weights)
    : lengths_(lengths), control_weights_(weights) {
  for (std::size_t d = 0; d < 3; ++d) {
    std::vector<std::pair<double, double>> nodes;
    add_nodes(knots[d], nodes);
    for (const double t : extra[d]) nodes.emplace_back(t, 1e-3 * knots[d].length());
    std::sort(nodes.begin(), nodes.end());
    Direction& direction = directions_[d];
    for (const auto& [t, w] : nodes) {
      if (!direction.nodes.empty() && t - direction.nodes.back() < 1e-12) {
        direction.weights.back() += w;
        continue;
      }
      direction.nodes.push_back(t);
      direction.weights.push_back(w);
    }
    direction.values = geometry::collocation(knots[d], direction.nodes);
    direction.slopes = geometry::collocation(knots[d], direction.nodes, 1);
  }
  const auto& [x, y, z] = directions_;
  weights_.resize(static_cast<Eigen::Index>(x.nodes.size() * y.nodes.size() * z.nodes.size()));
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < z.nodes.size(); ++k)
    for (std::size_t j = 0; j < y.nodes.size(); ++j)
      for (std::size_t i = 0; i < x.nodes.size(); ++i) {
        const int ends = at_end(x.nodes, i) + at_end(y.nodes, j) + at_end(z.nodes, k);
        const bool counts = ends < (counted == CountedPoints::all_but_corners ? 3 : 2);
        weights_[at++] = counts ? x.weights[i] * y.weights[j] * z.weights[k] : 0.0;
      }
  if (control_weights_.size() == 0) return;
  const Columns of_weights = at_nodes(control_weights_.transpose().replicate(3, 1));
  weight_function_.resize(4, weights_.size());
  for (Eigen::Index c = 0; c < 4; ++c)
    weight_function_.row(c) = of_weights[static_cast<std::size_t>(c)].row(0);
}

ShapeEnergy::Columns ShapeEnergy::at_nodes(const Eigen::Matrix3Xd& coefficients) const {
  const auto along = [](const Eigen::Matrix3Xd& values, const std::array<int, 3>& sizes, int d,
                        const Matrix& matrix) { return geometry::apply_along<3>(values, sizes, d, matrix); };
  const auto& [x, y, z] = directions_;
  const std::array<int, 3> n{static_cast<int>(x.values.cols()), static_cast<int>(y.values.cols()),
                             static_cast<int>(z.values.cols())};
  const std::array<int, 3> after_z{n[0], n[1], static_cast<int>(z.values.rows())};
  const std::array<int, 3> after_y{n[0], static_cast<int>(y.values.rows()), after_z[2]};
  const Eigen::Matrix3Xd value_z = along(coefficients, n, 2, z.values);
  const Eigen::Matrix3Xd slope_z = along(coefficients, n, 2, z.slopes);
  const Eigen::Matrix3Xd value_yz = along(value_z, after_z, 1, y.values);
  return {control_weights_.size() == 0 ? Eigen::Matrix3Xd() : along(value_yz, after_y, 0, x.values),
          along(value_yz, after_y, 0, x.slopes),
          along(along(value_z, after_z, 1, y.slopes), after_y, 0, x.values),
          along(along(slope_z, after_z, 1, y.values), after_y, 0, x.values)};
}

Eigen::Matrix3Xd ShapeEnergy::from_nodes(const Columns& columns) const {
  const auto back = [](const Eigen::Matrix3Xd& values, const std::array<int, 3>& sizes, int d,
                       const Matrix& matrix) {
    const Matrix transposed = matrix.transpose();
    return geometry::apply_along<3>(values, sizes, d, transposed);
  };
  const auto& [x, y, z] = directions_;
  const std::array<int, 3> m{static_cast<int>(x.values.rows()), static_cast<int>(y.values.rows()),
                             static_cast<int>(z.values.rows())};
  const std::array<int, 3> after_x{static_cast<int>(x.values.cols()), m[1], m[2]};
  const std::array<int, 3> after_y{after_x[0], static_cast<int>(y.values.cols()), m[2]};
  Eigen::Matrix3Xd in_x = back(columns[1], m, 0, x.slopes);
  if (control_weights_.size() > 0) in_x += back(columns[0], m, 0, x.values);
  Eigen::Matrix3Xd at_z_values = back(in_x, after_x, 1, y.values);
  at_z_values += back(back(columns[2], m, 0, x.values), after_x, 1, y.slopes);
  Eigen::Matrix3Xd result = back(at_z_values, after_y, 2, z.values);
  result += back(back(back(columns[3], m, 0, x.values), after_x, 1, y.values), after_y, 2, z.slopes);
  return result;
}

ShapeEnergy::Value ShapeEnergy::operator()(const Eigen::Matrix3Xd& points, double epsilon) const {
  const bool rational = control_weights_.size() > 0;
  Columns columns = at_nodes(rational ? Eigen::Matrix3Xd(points * control_weights_.asDiagonal()) : points);
  Value result;
  result.smallest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < weights_.size(); ++i) {
    const double weight = weights_[i];
    Eigen::Vector4d w(1, 0, 0, 0);
    if (rational) w = weight_function_.col(i);
    Eigen::Vector3d point(0, 0, 0);
    if (rational) {
      point = columns[0].col(i) / w[0];
      columns[0].col(i).setZero();
    }
    Eigen::Matrix3d jacobian;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto at = static_cast<Eigen::Index>(d);
      jacobian.col(at) = (columns[d + 1].col(i) - w[at + 1] * point) / (w[0] * lengths_[at]);
      columns[d + 1].col(i).setZero();
    }
    if (weight == 0) continue;
    const Integrand here = integrand(jacobian, epsilon);
    result.energy += weight * here.value;
    result.smallest = std::min(result.smallest, here.determinant);
    for (std::size_t d = 0; d < 3; ++d) {
      const auto at = static_cast<Eigen::Index>(d);
      const Eigen::Vector3d slope = weight / (w[0] * lengths_[at]) * here.slope.col(at);
      columns[d + 1].col(i) = slope;
      if (rational) columns[0].col(i) -= w[at + 1] / w[0] * slope;
    }
  }
  result.gradient = from_nodes(columns);
  if (rational) result.gradient = result.gradient * control_weights_.asDiagonal();
  return result;
}

}  // namespace isopatch::segmentation
