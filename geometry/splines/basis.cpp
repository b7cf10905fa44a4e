#include "geometry/splines/basis.hpp"

#include <algorithm>

namespace isopatch::geometry {

Eigen::RowVectorXd blossom_row(const KnotVector& knots, int span, const Eigen::VectorXd& arguments) {
  const int p = knots.degree();
  const auto& u = knots.knots();
  const auto knot = [&](int i) { return u[static_cast<std::size_t>(i)]; };
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(p + 1);
  row[0] = 1;
  // After step k the row holds the k + 1 functions of degree k that live on the span.
  for (int k = 1; k <= p; ++k) {
    const double t = arguments[k - 1];
    double carried = 0;
    for (int j = 0; j < k; ++j) {
      const double left = knot(span + 1 - k + j);
      const double right = knot(span + 1 + j);
      const double scaled = row[j] / (right - left);
      row[j] = carried + (right - t) * scaled;
      carried = (t - left) * scaled;
    }
    row[k] = carried;
  }
  return row;
}

BasisValues basis(const KnotVector& knots, double t, int order) {
  t = std::clamp(t, knots.first(), knots.last());
  const int span = knots.span(t);
  return {span - knots.degree(), basis_on_span(knots, span, t, order)};
}

Eigen::MatrixXd basis_on_span(const KnotVector& knots, int span, double t, int order) {
  const int p = knots.degree();
  const auto& u = knots.knots();
  const auto knot = [&](int i) { return u[static_cast<std::size_t>(i)]; };

  // Column k: the functions of degree k that live on the span, in rows 0 .. k.
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(p + 1, p + 1);
  triangle(0, 0) = 1;
  for (int k = 1; k <= p; ++k) {
    for (int j = 0; j < k; ++j) {
      const double left = knot(span + 1 - k + j);
      const double right = knot(span + 1 + j);
      const double scaled = triangle(j, k - 1) / (right - left);
      triangle(j, k) += (right - t) * scaled;
      triangle(j + 1, k) += (t - left) * scaled;
    }
  }

  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(order + 1, p + 1);
  result.row(0) = triangle.col(p).transpose();
  // The d-th derivative is the functions of degree p - d times d difference operators.
  for (int d = 1; d <= std::min(order, p); ++d) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(p + 1);
    row.head(p - d + 1) = triangle.col(p - d).head(p - d + 1).transpose();
    for (int k = p - d + 1; k <= p; ++k) {
      double carried = 0;
      for (int j = 0; j < k; ++j) {
        const double scaled = k * row[j] / (knot(span + 1 + j) - knot(span + 1 - k + j));
        row[j] = carried - scaled;
        carried = scaled;
      }
      row[k] = carried;
    }
    result.row(d) = row;
  }
  return result;
}

}  // namespace isopatch::geometry
