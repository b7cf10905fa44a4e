#include "geometry/jacobian_expansion.hpp"

#include "geometry/determinant_bounds.hpp"

#include <array>
#include <limits>
#include <vector>

namespace isopatch::geometry {
namespace {

using Vector = std::vector<BernsteinPolynomial>;  // one polynomial per component

Vector derivative(const Vector& components, int direction) {
  Vector result;
  for (const BernsteinPolynomial& c : components) result.push_back(derivative(c, direction));
  return result;
}

BernsteinPolynomial minor(const Vector& a, const Vector& b, std::size_t i, std::size_t j) {
  return a[i] * b[j] - a[j] * b[i];
}

BernsteinPolynomial determinant3(const std::array<Vector, 3>& columns) {
  const auto& [u, v, w] = columns;
  return u[0] * minor(v, w, 1, 2) + u[1] * minor(v, w, 2, 0) + u[2] * minor(v, w, 0, 1);
}

// Laplace expansion along the first two columns.
BernsteinPolynomial determinant4(const Vector& h, const std::array<Vector, 3>& columns) {
  const Vector &u = columns[0], &v = columns[1], &w = columns[2];
  const auto term = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return minor(h, u, i, j) * minor(v, w, k, l);
  };
  return term(0, 1, 2, 3) + term(0, 2, 3, 1) + term(0, 3, 1, 2) + term(1, 2, 0, 3) + term(1, 3, 2, 0) +
         term(2, 3, 0, 1);
}

// Largest sum over the components of the magnitudes of their coefficients at one place.
double largest(const Vector& components) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(components[0].coefficients.size());
  for (const BernsteinPolynomial& c : components) sum += c.coefficients.cwiseAbs();
  return sum.maxCoeff();
}

// A determinant's coefficients are averages of sums of products of one component from each column, of which
// the magnitudes add up to at most the product of the columns' sizes. The first part is the round-off of the
// products and sums, at most two nested ones with as many terms as control points; the second is what errors
// of the coefficients themselves (from scaling and Bezier extraction, then differences) change.
double error_bound(const NurbsVolume& piece, const std::vector<double>& sizes,
                   const std::vector<double>& errors) {
  double product = 1;
  for (const double s : sizes) product *= s;
  double bound = (2.0 * piece.size() + 64) * unit_roundoff * product;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    double term = errors[i];
    for (std::size_t j = 0; j < sizes.size(); ++j)
      if (j != i) term *= sizes[j] + errors[j];
    bound += term;
  }
  return bound;
}

}  // namespace

JacobianExpansion expand_jacobian(const NurbsVolume& piece) {
  const bool rational = piece.is_rational();
  const std::array<int, 3> degree = {piece.degree(0), piece.degree(1), piece.degree(2)};
  const Eigen::Matrix4Xd homogeneous = piece.homogeneous() / (rational ? 1.0 : piece.weights()[0]);
  Vector components;
  for (int c = 0; c < (rational ? 4 : 3); ++c) components.push_back({degree, homogeneous.row(c)});
  const double coefficient_error = 16.0 * (degree[0] + degree[1] + degree[2] + 3) * unit_roundoff *
                                   std::max(1.0, homogeneous.cwiseAbs().maxCoeff());

  std::array<Vector, 3> columns;
  std::vector<double> sizes;
  std::vector<double> errors;
  for (int d = 0; d < 3; ++d) {
    const auto k = static_cast<std::size_t>(d);
    columns[k] = derivative(components, d);
    sizes.push_back(largest(columns[k]));
    errors.push_back(2.0 * degree[k] * static_cast<double>(components.size()) * coefficient_error);
  }
  JacobianExpansion result;
  if (rational) {
    sizes.push_back(largest(components));
    errors.push_back(4 * coefficient_error);
    result.numerator = determinant4(components, columns);
    result.numerator.coefficients *= -1;
    result.lowest_weight = piece.weights().minCoeff();
    result.highest_weight = piece.weights().maxCoeff();
  } else {
    result.numerator = determinant3(columns);
  }
  result.error = error_bound(piece, sizes, errors);
  return result;
}

}  // namespace isopatch::geometry
