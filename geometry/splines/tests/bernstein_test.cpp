#include "geometry/splines/bernstein.hpp"

#include <gtest/gtest.h>

#include <random>

namespace isopatch::geometry {
namespace {

BernsteinPolynomial random_polynomial(std::mt19937& random, int max_degree) {
  std::uniform_int_distribution<int> degree(0, max_degree);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  BernsteinPolynomial p;
  p.degree = {degree(random), degree(random), degree(random)};
  const auto [l, m, n] = p.sizes();
  p.coefficients.resize(l * m * n);
  for (double& c : p.coefficients) c = coefficient(random);
  return p;
}

Eigen::Vector3d random_place(std::mt19937& random) {
  std::uniform_real_distribution<double> share;
  return {share(random), share(random), share(random)};
}

TEST(Bernstein, ProductsMultiplyValues) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const auto a = random_polynomial(random, 5);
    const auto b = random_polynomial(random, 5);
    const auto product = a * b;
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(product.degree[d], a.degree[d] + b.degree[d]);
    const Eigen::Vector3d at = random_place(random);
    EXPECT_NEAR(value(product, at), value(a, at) * value(b, at), 1e-14);
    EXPECT_NEAR(value(product - b * a, at), 0, 1e-14);
  }
}

TEST(Bernstein, ProductsStayAccurateAtHighDegree) {
  // One times one is one, whatever the degree: every coefficient is an average.
  const BernsteinPolynomial one{{20, 20, 20}, Eigen::RowVectorXd::Ones(21 * 21 * 21)};
  const BernsteinPolynomial product =
      one * BernsteinPolynomial{{20, 1, 3}, Eigen::RowVectorXd::Ones(21 * 2 * 4)};
  EXPECT_LT((product.coefficients.array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), 1e-14);
}

TEST(Bernstein, HalvesAreTheSamePolynomial) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 30; ++trial) {
    const auto p = random_polynomial(random, 8);
    const int d = trial % 3;
    const auto parts = halves(p, d);
    Eigen::Vector3d at = random_place(random);
    const double lower = value(parts[0], at);
    const double upper = value(parts[1], at);
    at[d] *= 0.5;
    EXPECT_NEAR(value(p, at), lower, 1e-14);
    at[d] += 0.5;
    EXPECT_NEAR(value(p, at), upper, 1e-14);
  }
}

TEST(Bernstein, DerivativesMatchTheProductRule) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 30; ++trial) {
    const auto a = random_polynomial(random, 4);
    const auto b = random_polynomial(random, 4);
    const int d = trial % 3;
    const Eigen::Vector3d at = random_place(random);
    EXPECT_NEAR(value(derivative(a * b, d), at),
                value(derivative(a, d), at) * value(b, at) + value(a, at) * value(derivative(b, d), at),
                1e-12);
  }
  // x y^2 z on the unit cube, differentiated along y: 2 x y z.
  const BernsteinPolynomial x{{1, 0, 0}, Eigen::RowVector2d(0, 1)};
  const BernsteinPolynomial y{{0, 1, 0}, Eigen::RowVector2d(0, 1)};
  const BernsteinPolynomial z{{0, 0, 1}, Eigen::RowVector2d(0, 1)};
  EXPECT_NEAR(value(derivative(x * y * y * z, 1), {0.5, 0.25, 0.75}), 2 * 0.5 * 0.25 * 0.75, 1e-15);
}

TEST(Bernstein, FindsTheCurvedDirection) {
  const BernsteinPolynomial x{{1, 0, 0}, Eigen::RowVector2d(0, 1)};
  const BernsteinPolynomial y{{0, 1, 0}, Eigen::RowVector2d(0, 1)};
  const BernsteinPolynomial z{{0, 0, 1}, Eigen::RowVector2d(0, 1)};
  EXPECT_EQ(most_curved_direction(x * y * z * z), 2);
  EXPECT_EQ(most_curved_direction(x * x * y * z), 0);
  EXPECT_EQ(most_curved_direction(x * y * y * z), 1);
}

}  // namespace
}  // namespace isopatch::geometry
