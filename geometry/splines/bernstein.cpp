#include "geometry/splines/bernstein.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/splines/tensor.hpp"

namespace isopatch::geometry {
namespace {

Eigen::VectorXd binomials(int n) {
  Eigen::VectorXd row(n + 1);
  row[0] = 1;
  for (int k = 1; k <= n; ++k) row[k] = row[k - 1] * (n - k + 1) / k;
  return row;
}

// The product of the binomial coefficients that belongs to each coefficient of a polynomial.
Eigen::ArrayXd binomials(const std::array<int, 3>& degree) {
  const Eigen::VectorXd a = binomials(degree[0]);
  const Eigen::VectorXd b = binomials(degree[1]);
  const Eigen::VectorXd c = binomials(degree[2]);
  Eigen::ArrayXd result(a.size() * b.size() * c.size());
  for (Eigen::Index k = 0; k < c.size(); ++k)
    for (Eigen::Index j = 0; j < b.size(); ++j)
      result.segment((k * b.size() + j) * a.size(), a.size()) = a.array() * (b[j] * c[k]);
  return result;
}

// The coefficients of the lower half from those of the whole: row i holds the weights binomial(i, j) / 2^i.
Eigen::MatrixXd lower_half(int degree) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
  for (int i = 0; i <= degree; ++i)
    matrix.row(i).head(i + 1) = binomials(i).transpose() * std::ldexp(1.0, -i);
  return matrix;
}

}  // namespace

BernsteinPolynomial operator+(const BernsteinPolynomial& a, const BernsteinPolynomial& b) {
  assert(a.degree == b.degree);
  return {a.degree, a.coefficients + b.coefficients};
}

BernsteinPolynomial operator-(const BernsteinPolynomial& a, const BernsteinPolynomial& b) {
  assert(a.degree == b.degree);
  return {a.degree, a.coefficients - b.coefficients};
}

BernsteinPolynomial operator*(const BernsteinPolynomial& a, const BernsteinPolynomial& b) {
  BernsteinPolynomial result;
  for (std::size_t d = 0; d < 3; ++d) result.degree[d] = a.degree[d] + b.degree[d];
  const auto [n0, n1, n2] = result.sizes();
  const auto [a0, a1, a2] = a.sizes();
  const auto [b0, b1, b2] = b.sizes();
  // With the binomial coefficients multiplied in, the product is a convolution.
  const Eigen::ArrayXd scaled_a = a.coefficients.transpose().array() * binomials(a.degree);
  const Eigen::ArrayXd scaled_b = b.coefficients.transpose().array() * binomials(b.degree);
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(n0) * n1 * n2);
  for (int kb = 0; kb < b2; ++kb)
    for (int jb = 0; jb < b1; ++jb)
      for (int ka = 0; ka < a2; ++ka)
        for (int ja = 0; ja < a1; ++ja) {
          const auto row = scaled_a.segment((ka * a1 + ja) * a0, a0);
          double* const target = sum.data() + ((ka + kb) * n1 + ja + jb) * n0;
          for (int ib = 0; ib < b0; ++ib)
            Eigen::Map<Eigen::ArrayXd>(target + ib, a0) += scaled_b[(kb * b1 + jb) * b0 + ib] * row;
        }
  result.coefficients = (sum / binomials(result.degree)).matrix().transpose();
  return result;
}

BernsteinPolynomial derivative(const BernsteinPolynomial& polynomial, int direction) {
  const int p = polynomial.degree[static_cast<std::size_t>(direction)];
  if (p == 0) return {polynomial.degree, Eigen::RowVectorXd::Zero(polynomial.coefficients.size())};
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(p, p + 1);
  difference.diagonal().setConstant(-p);
  difference.diagonal(1).setConstant(p);
  BernsteinPolynomial result = polynomial;
  --result.degree[static_cast<std::size_t>(direction)];
  result.coefficients = apply_along<3>(polynomial.coefficients, polynomial.sizes(), direction, difference);
  return result;
}

std::array<BernsteinPolynomial, 2> halves(const BernsteinPolynomial& polynomial, int direction) {
  const Eigen::MatrixXd lower = lower_half(polynomial.degree[static_cast<std::size_t>(direction)]);
  const Eigen::MatrixXd upper = lower.reverse();
  const auto apply = [&](const Eigen::MatrixXd& half) -> BernsteinPolynomial {
    return {polynomial.degree, apply_along<3>(polynomial.coefficients, polynomial.sizes(), direction, half)};
  };
  return {apply(lower), apply(upper)};
}

int most_curved_direction(const BernsteinPolynomial& polynomial) {
  const Eigen::RowVectorXd& c = polynomial.coefficients;
  int most = 0;
  double largest = -1;
  Eigen::Index stride = 1;
  for (int d = 0; d < 3; ++d) {
    const int n = polynomial.degree[static_cast<std::size_t>(d)];
    double difference = 0;
    for (Eigen::Index i = stride; i + stride < c.size(); ++i) {
      const Eigen::Index along = i / stride % (n + 1);
      if (along > 0 && along < n)
        difference = std::max(difference, std::abs(c[i - stride] - 2 * c[i] + c[i + stride]));
    }
    if (n * difference > largest) {
      largest = n * difference;
      most = d;
    }
    stride *= n + 1;
  }
  return most;
}

double value(const BernsteinPolynomial& polynomial, const Eigen::Vector3d& parameter) {
  Eigen::RowVectorXd rest = polynomial.coefficients;
  std::array<int, 3> sizes = polynomial.sizes();
  for (int d = 2; d >= 0; --d) {
    const Eigen::Index inner = rest.size() / sizes[static_cast<std::size_t>(d)];
    for (Eigen::Index left = sizes[static_cast<std::size_t>(d)] - 1; left > 0; --left)
      rest.head(left * inner) =
          ((1 - parameter[d]) * rest.head(left * inner) + parameter[d] * rest.segment(inner, left * inner))
              .eval();
    rest.conservativeResize(inner);
  }
  return rest[0];
}

}  // namespace isopatch::geometry
