#include "iga/spaces/element.hpp"

#include <Eigen/LU>

namespace isopatch::iga {

ElementEvaluator::ElementEvaluator(const geometry::NurbsVolume& patch, int points)
    : patch_(&patch), tables_(patch, points) {}

ElementEvaluator::ElementEvaluator(const geometry::NurbsVolume& patch,
                                   const std::array<geometry::QuadratureRule, 3>& rules)
    : patch_(&patch), tables_(patch, rules) {}

void ElementEvaluator::evaluate(std::int64_t element, ElementValues& out) const {
  const auto [u, v, w] = tables_.of(element);
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
