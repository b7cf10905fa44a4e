#pragma once

#include <Eigen/Core>
#include <array>

namespace isopatch::geometry {

/// A polynomial on the unit cube in Bernstein form: it lies between its smallest and largest coefficient, and
/// equals the corner coefficients at the corners.
struct BernsteinPolynomial {
  std::array<int, 3> degree = {0, 0, 0};
  Eigen::RowVectorXd coefficients =
      Eigen::RowVectorXd::Zero(1);  ///< (product of degree + 1), first direction fastest

  std::array<int, 3> sizes() const { return {degree[0] + 1, degree[1] + 1, degree[2] + 1}; }
};

/// Of equal degrees.
BernsteinPolynomial operator+(const BernsteinPolynomial& a, const BernsteinPolynomial& b);
BernsteinPolynomial operator-(const BernsteinPolynomial& a, const BernsteinPolynomial& b);

/// Every coefficient of a product is an average, with positive weights, of products of the factors'
/// coefficients, so its round-off is at most (n + 12) u max|a| max|b|, n the size of the smaller factor and u
/// = 2^-53.
/// @cost O(size of a times size of b)
BernsteinPolynomial operator*(const BernsteinPolynomial& a, const BernsteinPolynomial& b);

/// Partial derivative; the degree along the direction drops by one.
BernsteinPolynomial derivative(const BernsteinPolynomial& polynomial, int direction);

/// The polynomial on the lower and on the upper half of the cube along one direction, each scaled to the unit
/// cube. Round-off at most (degree + 2) u max|coefficient|.
std::array<BernsteinPolynomial, 2> halves(const BernsteinPolynomial& polynomial, int direction);

/// The direction whose halving brings the coefficients closest to the polynomial: the one with the largest
/// degree times second difference of the coefficients.
int most_curved_direction(const BernsteinPolynomial& polynomial);

/// By de Casteljau's algorithm.
double value(const BernsteinPolynomial& polynomial, const Eigen::Vector3d& parameter);

}  // namespace isopatch::geometry
