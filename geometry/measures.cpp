#include "geometry/measures.hpp"

#include <Eigen/LU>
#include <array>
#include <limits>
#include <vector>

#include "geometry/quadrature.hpp"

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

// Calls visit(parameter, weight) at all Gauss points; `points(direction)` says how many per element.
template <int D, class Points, class Visit>
void at_gauss_points(const Nurbs<D>& spline, Points points, Visit visit) {
  std::array<DirectionRule, D> rules;
  std::size_t count = 1;
  for (std::size_t d = 0; d < D; ++d) {
    rules[d] = rule_on(spline.knots()[d], points(static_cast<int>(d)));
    count *= rules[d].nodes.size();
  }
  for (std::size_t i = 0; i < count; ++i) {
    Parameter<D> parameter;
    double weight = 1;
    std::size_t rest = i;
    for (std::size_t d = 0; d < D; ++d) {
      const std::size_t k = rest % rules[d].nodes.size();
      rest /= rules[d].nodes.size();
      parameter[static_cast<int>(d)] = rules[d].nodes[k];
      weight *= rules[d].weights[k];
    }
    visit(parameter, weight);
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

Eigen::AlignedBox3d box(const MultiPatch& model) {
  Eigen::AlignedBox3d result;
  for (const NurbsVolume& patch : model.patches()) result.extend(box(patch));
  return result;
}

double volume(const NurbsVolume& patch) {
  double sum = 0;
  at_gauss_points(
      patch, [&](int d) { return points_for(patch, d); },
      [&](const Parameter<3>& at, double weight) { sum += weight * patch.jacobian(at).determinant(); });
  return sum;
}

double area(const NurbsSurface& surface) {
  double sum = 0;
  at_gauss_points(
      surface, [&](int d) { return points_for(surface, d); },
      [&](const Parameter<2>& at, double weight) {
        const Eigen::Matrix<double, 3, 2> columns = surface.jacobian(at);
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

Quality quality(const NurbsVolume& patch, int points_per_direction) {
  Quality result{std::numeric_limits<double>::infinity(), 0, std::numeric_limits<double>::infinity(), {}};
  int count = 0;
  at_gauss_points(
      patch, [&](int d) { return points_per_direction > 0 ? points_per_direction : patch.degree(d) + 1; },
      [&](const Parameter<3>& at, double) {
        const Eigen::Matrix3d columns = patch.jacobian(at);
        const double determinant = columns.determinant();
        const double lengths = columns.colwise().norm().prod();
        const double scaled = lengths > 0 ? determinant / lengths : 0;
        result.min_scaled_jacobian = std::min(result.min_scaled_jacobian, scaled);
        result.mean_scaled_jacobian += scaled;
        ++count;
        if (determinant >= result.min_jacobian) return;
        result.min_jacobian = determinant;
        result.worst_parameter = at;
      });
  result.mean_scaled_jacobian /= count;
  return result;
}

}  // namespace isopatch::geometry
