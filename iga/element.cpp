#include "iga/element.hpp"

#include <Eigen/LU>

#include "geometry/splines/basis.hpp"

namespace isopatch::iga {

DirectionTable direction_table(const geometry::KnotVector& knots, const geometry::QuadratureRule& rule) {
  DirectionTable table;
  const std::vector<double> breaks = knots.breaks();
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) {
    const double length = breaks[e + 1] - breaks[e];
    DirectionTable::Element element;
    element.nodes = breaks[e] + length * rule.nodes.array();
    element.weights = length * rule.weights;
    element.values.resize(rule.nodes.size(), knots.degree() + 1);
    element.derivatives.resize(rule.nodes.size(), knots.degree() + 1);
    // A point on the element's high end belongs to the next span; a hair before it the span is right, and the
    // polynomials of that span are then evaluated at the point itself.
    const int span = knots.span(0.5 * (breaks[e] + breaks[e + 1]));
    element.first = span - knots.degree();
    for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
      const Eigen::MatrixXd at = geometry::basis_on_span(knots, span, element.nodes[q], 1);
      element.values.row(q) = at.row(0);
      element.derivatives.row(q) = at.row(1);
    }
    table.elements.push_back(std::move(element));
  }
  return table;
}

namespace {

std::array<geometry::QuadratureRule, 3> gauss_rules(const geometry::NurbsVolume& patch, int points) {
  std::array<geometry::QuadratureRule, 3> rules;
  for (int d = 0; d < 3; ++d)
    rules[static_cast<std::size_t>(d)] = geometry::gauss_legendre(points > 0 ? points : patch.degree(d) + 1);
  return rules;
}

}  // namespace

ElementEvaluator::ElementEvaluator(const geometry::NurbsVolume& patch, int points)
    : ElementEvaluator(patch, gauss_rules(patch, points)) {}

ElementEvaluator::ElementEvaluator(const geometry::NurbsVolume& patch,
                                   const std::array<geometry::QuadratureRule, 3>& rules)
    : patch_(&patch) {
  for (std::size_t d = 0; d < 3; ++d) tables_[d] = direction_table(patch.knots()[d], rules[d]);
}

std::int64_t ElementEvaluator::element_count() const {
  std::int64_t count = 1;
  for (const DirectionTable& table : tables_) count *= static_cast<std::int64_t>(table.elements.size());
  return count;
}

std::array<const DirectionTable::Element*, 3> ElementEvaluator::of(std::int64_t element) const {
  std::array<const DirectionTable::Element*, 3> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto count = static_cast<std::int64_t>(tables_[d].elements.size());
    result[d] = &tables_[d].elements[static_cast<std::size_t>(element % count)];
    element /= count;
  }
  return result;
}

geometry::Parameter<3> ElementEvaluator::parameter(std::int64_t element, Eigen::Index point) const {
  const auto directions = of(element);
  geometry::Parameter<3> result;
  for (int d = 0; d < 3; ++d) {
    const Eigen::VectorXd& nodes = directions[static_cast<std::size_t>(d)]->nodes;
    result[d] = nodes[point % nodes.size()];
    point /= nodes.size();
  }
  return result;
}

void ElementEvaluator::evaluate(std::int64_t element, ElementValues& out) const {
  const auto [u, v, w] = of(element);
  const Eigen::Index nu = u->values.cols(), nv = v->values.cols(), nw = w->values.cols();
  const Eigen::Index qu = u->values.rows(), qv = v->values.rows(), qw = w->values.rows();
  const Eigen::Index n = nu * nv * nw;
  const Eigen::Index q = qu * qv * qw;

  out.functions.resize(static_cast<std::size_t>(n));
  Eigen::Matrix3Xd points(3, n);
  Eigen::ArrayXd weights(n);
  for (Eigen::Index k = 0, a = 0; k < nw; ++k) {
    for (Eigen::Index j = 0; j < nv; ++j) {
      for (Eigen::Index i = 0; i < nu; ++i, ++a) {
        const Eigen::Index index =
            (u->first + i) + patch_->size(0) * ((v->first + j) + patch_->size(1) * (w->first + k));
        out.functions[static_cast<std::size_t>(a)] = static_cast<int>(index);
        points.col(a) = patch_->control_points().col(index);
        weights[a] = patch_->weights()[index];
      }
    }
  }

  for (Eigen::MatrixXd& gradient : out.gradients) gradient.resize(n, q);
  out.values.resize(n, q);
  out.measures.resize(q);
  out.jacobians.resize(q);
  out.places.resize(3, q);
  Eigen::ArrayXd value(n);
  Eigen::ArrayX3d derivative(n, 3);
  const bool rational = patch_->is_rational();
  for (Eigen::Index qk = 0, point = 0; qk < qw; ++qk) {
    for (Eigen::Index qj = 0; qj < qv; ++qj) {
      for (Eigen::Index qi = 0; qi < qu; ++qi, ++point) {
        for (Eigen::Index k = 0, a = 0; k < nw; ++k) {
          for (Eigen::Index j = 0; j < nv; ++j, a += nu) {
            const double vv = v->values(qj, j) * w->values(qk, k);
            const double dv = v->derivatives(qj, j) * w->values(qk, k);
            const double dw = v->values(qj, j) * w->derivatives(qk, k);
            value.segment(a, nu) = vv * u->values.row(qi).transpose().array();
            derivative.col(0).segment(a, nu) = vv * u->derivatives.row(qi).transpose().array();
            derivative.col(1).segment(a, nu) = dv * u->values.row(qi).transpose().array();
            derivative.col(2).segment(a, nu) = dw * u->values.row(qi).transpose().array();
          }
        }
        if (rational) {
          value *= weights;
          const double total = value.sum();
          value /= total;
          for (int d = 0; d < 3; ++d) {
            derivative.col(d) *= weights / total;
            derivative.col(d) -= derivative.col(d).sum() * value;
          }
        }
        const Eigen::Matrix3d jacobian = points * derivative.matrix();
        const double determinant = jacobian.determinant();
        const Eigen::Matrix3d inverse = jacobian.inverse();
        for (int d = 0; d < 3; ++d)
          out.gradients[static_cast<std::size_t>(d)].col(point) = derivative.matrix() * inverse.col(d);
        out.values.col(point) = value.matrix();
        out.places.col(point) = points * value.matrix();
        out.jacobians[point] = determinant;
        out.measures[point] = u->weights[qi] * v->weights[qj] * w->weights[qk] * determinant;
      }
    }
  }
}

}  // namespace isopatch::iga
