#include "geometry/measures.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "geometry/jacobian_grid.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/tensor.hpp"

namespace isopatch::geometry {
namespace {

/// Gauss points and weights of one direction on all its elements.
struct DirectionRule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

DirectionRule rule_on(const KnotVector& knots, int points) {
  const QuadratureRule unit = gauss_legendre(points);
  const std::vector<double> breaks = knots.breaks();
  DirectionRule rule;
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    for (Eigen::Index i = 0; i < unit.nodes.size(); ++i) {
      const double length = breaks[e + 1] - breaks[e];
      rule.nodes.push_back(breaks[e] + length * unit.nodes[i]);
      rule.weights.push_back(length * unit.weights[i]);
    }
  return rule;
}

/// A direction's rule with the basis functions and their derivatives at its nodes.
struct DirectionTable {
  DirectionRule rule;
  std::array<Eigen::SparseMatrix<double, Eigen::RowMajor>, 2> basis;  ///< by order of derivative
};

// Homogeneous values on all nodes of all directions but the last, and on node `last` of that one;
// differentiated once along `differentiated`, if that is a direction.
template <int D>
Eigen::Matrix4Xd slab(const Eigen::Matrix4Xd& homogeneous, std::array<int, D> sizes,
                      const std::array<DirectionTable, D>& tables, int last, int differentiated) {
  const auto& through = tables[D - 1].basis[differentiated == D - 1 ? 1 : 0];
  // The control points behind the node: without this every node would look at all of them.
  const Eigen::Index row_end = through.outerIndexPtr()[last + 1];
  const Eigen::Index low = through.innerIndexPtr()[through.outerIndexPtr()[last]];
  const Eigen::Index count = through.innerIndexPtr()[row_end - 1] + 1 - low;
  const Eigen::Index layer = homogeneous.cols() / sizes[D - 1];
  const Eigen::RowVectorXd row = through.row(last);
  Eigen::Matrix4Xd values = Eigen::Matrix4Xd::Zero(4, layer);
  for (Eigen::Index k = low; k < low + count; ++k)
    values += row[k] * homogeneous.middleCols(k * layer, layer);
  sizes[D - 1] = 1;
  for (int d = D - 2; d >= 0; --d) {
    const auto k = static_cast<std::size_t>(d);
    const auto& rows = tables[k].basis[d == differentiated ? 1 : 0];
    values = apply_along<D>(values, sizes, d, rows);
    sizes[k] = static_cast<int>(rows.rows());
  }
  return values;
}

// Calls visit(parameter, weight, point, jacobian) at all Gauss points; `points(direction)` says how many per
// element.
template <int D, class Points, class Visit>
void at_gauss_points(const Nurbs<D>& spline, Points points, Visit visit) {
  std::array<DirectionTable, D> tables;
  for (std::size_t d = 0; d < D; ++d) {
    tables[d].rule = rule_on(spline.knots()[d], points(static_cast<int>(d)));
    for (const int order : {0, 1})
      tables[d].basis[static_cast<std::size_t>(order)] =
          collocation(spline.knots()[d], tables[d].rule.nodes, order);
  }
  const Eigen::Matrix4Xd homogeneous = spline.homogeneous();
  const DirectionRule& last = tables[D - 1].rule;
  for (std::size_t k = 0; k < last.nodes.size(); ++k) {
    const auto node = static_cast<int>(k);
    const Eigen::Matrix4Xd values = slab<D>(homogeneous, spline.sizes(), tables, node, -1);
    std::array<Eigen::Matrix4Xd, D> derivatives;
    for (int d = 0; d < D; ++d)
      derivatives[static_cast<std::size_t>(d)] = slab<D>(homogeneous, spline.sizes(), tables, node, d);
    for (Eigen::Index i = 0; i < values.cols(); ++i) {
      Parameter<D> parameter;
      double weight = last.weights[k];
      parameter[D - 1] = last.nodes[k];
      auto rest = static_cast<std::size_t>(i);
      for (std::size_t d = 0; d + 1 < D; ++d) {
        const DirectionRule& rule = tables[d].rule;
        parameter[static_cast<int>(d)] = rule.nodes[rest % rule.nodes.size()];
        weight *= rule.weights[rest % rule.nodes.size()];
        rest /= rule.nodes.size();
      }
      const Eigen::Vector3d point = values.col(i).template head<3>() / values(3, i);
      Eigen::Matrix<double, 3, D> jacobian;
      for (int d = 0; d < D; ++d) {
        const auto h = derivatives[static_cast<std::size_t>(d)].col(i);
        jacobian.col(d) = (h.template head<3>() - h[3] * point) / values(3, i);
      }
      visit(parameter, weight, point, jacobian);
    }
  }
}

// Exact for the Jacobian determinant of a B-spline, degree 3p - 1; a rational integrand gets twice as many.
template <int D>
int points_for(const Nurbs<D>& spline, int direction) {
  const int p = spline.degree(direction);
  return spline.is_rational() ? 2 * p + 8 : (3 * p + 1) / 2 + 1;
}

}  // namespace

Eigen::AlignedBox3d box(const NurbsVolume& volume) {
  return {volume.control_points().rowwise().minCoeff(), volume.control_points().rowwise().maxCoeff()};
}

// By Gauss's theorem: a third of the flux of the position, seen from the middle, through the six sides.
double volume(const NurbsVolume& patch) {
  const Eigen::Vector3d middle = box(patch).center();
  double sum = 0;
  for (const Side side : all_sides) {
    const NurbsSurface surface = face_surface(patch, side);
    // The two tangents and the outward normal are right-handed there.
    const double sign = is_high(side) != (direction(side) == 1) ? 1 : -1;
    at_gauss_points(
        surface, [&](int d) { return points_for(surface, d); },
        [&](const Parameter<2>&, double weight, const Eigen::Vector3d& point,
            const Eigen::Matrix<double, 3, 2>& columns) {
          sum += sign * weight * (point - middle).dot(columns.col(0).cross(columns.col(1))) / 3;
        });
  }
  return sum;
}

// By Gauss's theorem with the fields x_i^2 / 2 e_i, x_i^2 x_j / 2 e_i and x_i^3 / 3 e_i.
VolumeMoments volume_moments(const NurbsVolume& patch, const Eigen::Vector3d& origin) {
  VolumeMoments result;
  for (const Side side : all_sides) {
    const NurbsSurface surface = face_surface(patch, side);
    const double sign = is_high(side) != (direction(side) == 1) ? 1 : -1;
    at_gauss_points(
        surface, [&](int d) { return points_for(surface, d) + surface.degree(d); },
        [&](const Parameter<2>&, double weight, const Eigen::Vector3d& point,
            const Eigen::Matrix<double, 3, 2>& columns) {
          const Eigen::Vector3d x = point - origin;
          const Eigen::Vector3d flux = sign * weight * columns.col(0).cross(columns.col(1));
          result.volume += x.dot(flux) / 3;
          result.first += 0.5 * x.cwiseProduct(x).cwiseProduct(flux);
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              result.second(i, j) += x[i] * x[i] * x[j] * flux[i] / (i == j ? 3 : 2);
        });
  }
  result.second = (0.5 * (result.second + result.second.transpose())).eval();
  return result;
}

double area(const NurbsSurface& surface) {
  double sum = 0;
  at_gauss_points(
      surface, [&](int d) { return points_for(surface, d); },
      [&](const Parameter<2>&, double weight, const Eigen::Vector3d&,
          const Eigen::Matrix<double, 3, 2>& columns) {
        sum += weight * columns.col(0).cross(columns.col(1)).norm();
      });
  return sum;
}

Eigen::Vector3d outward_normal(const NurbsVolume& patch, Side side, const Parameter<2>& face_parameter) {
  const Eigen::Matrix3d columns = patch.jacobian(on_side(patch, side, face_parameter));
  const int d = direction(side);
  const Eigen::Vector3d along = columns.col((d + 1) % 3).cross(columns.col((d + 2) % 3)).normalized();
  return is_high(side) ? along : Eigen::Vector3d(-along);
}

Quality quality(const NurbsVolume& patch, int points_per_direction, const Progress& progress) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Quality result{infinity, 0, infinity, {}};
  GridParameters<3> nodes;
  double count = 1;
  for (int d = 0; d < 3; ++d) {
    const int points = points_per_direction > 0 ? points_per_direction : patch.degree(d) + 1;
    nodes[static_cast<std::size_t>(d)] = rule_on(patch.knots(d), points).nodes;
    count *= static_cast<double>(nodes[static_cast<std::size_t>(d)].size());
  }
  const auto node = [&](std::size_t d, Eigen::Index i) { return nodes[d][static_cast<std::size_t>(i)]; };
  for_each_line(patch, nodes, [&](const JacobianLine& line) {
    if (line.first == 0) progress("measuring quality", double(line.third) / double(nodes[2].size()));
    const Eigen::ArrayXd determinants = line.determinants(), squares = line.squared_lengths();
    const Eigen::ArrayXd scaled = (squares > 0).select(determinants / squares.sqrt(), 0.0);
    result.min_scaled_jacobian = std::min(result.min_scaled_jacobian, scaled.minCoeff());
    result.mean_scaled_jacobian += scaled.sum();
    Eigen::Index at = 0;
    const double smallest = determinants.minCoeff(&at);
    if (smallest >= result.min_jacobian) return;
    result.min_jacobian = smallest;
    result.worst_parameter = {node(0, line.first), node(1, at), node(2, line.third)};
  });
  result.mean_scaled_jacobian /= count;
  return result;
}

}  // namespace isopatch::geometry
