#include "solvers/multigrid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::solvers {
namespace {

// Springs in a row, both ends held, in three components.
Eigen::MatrixXd chain(int nodes) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
  for (int i = 0; i < nodes; ++i)
    for (int c = 0; c < 3; ++c) {
      a(3 * i + c, 3 * i + c) = 2.0 * (c + 1);
      if (i > 0) a(3 * i + c, 3 * i - 3 + c) = a(3 * i - 3 + c, 3 * i + c) = -(c + 1.0);
    }
  return a;
}

// Linear interpolation from every second node.
Eigen::MatrixXd interpolation(int coarse) {
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(3 * (2 * coarse + 1), 3 * coarse);
  for (int i = 0; i < coarse; ++i)
    for (int c = 0; c < 3; ++c) {
      p(3 * (2 * i + 1) + c, 3 * i + c) = 1;
      p(3 * (2 * i) + c, 3 * i + c) = p(3 * (2 * i + 2) + c, 3 * i + c) = 0.5;
    }
  return p;
}

LinearOperator times(const Eigen::MatrixXd& matrix) {
  return [matrix](const Eigen::VectorXd& x) { return Eigen::VectorXd(matrix * x); };
}

LinearOperator inverse_diagonal(const Eigen::MatrixXd& a) {
  return times(a.diagonal().cwiseInverse().asDiagonal());
}

Multigrid two_grids(int coarse) {
  const int fine = 2 * coarse + 1;
  const Eigen::MatrixXd a = chain(fine);
  const Eigen::MatrixXd p = interpolation(coarse);
  const Eigen::MatrixXd inverse = pseudo_inverse(p.transpose() * a * p);
  return Multigrid({{SharedRows(fine), times(a), inverse_diagonal(a), {}, {}},
                    {SharedRows(coarse), {}, {}, times(p), times(p.transpose())}},
                   times(inverse), {.smoothing_degree = 2, .smoothing_range = 4});
}

TEST(LargestEigenvalue, IsFoundFromBelow) {
  const Eigen::MatrixXd a = chain(40);
  const Eigen::MatrixXd diagonal = a.diagonal().asDiagonal();
  const double exact = symmetric_eigen(a, diagonal).values.maxCoeff<Eigen::PropagateNaN>();
  const double found = largest_eigenvalue(times(a), inverse_diagonal(a), SharedRows(40), 20);
  EXPECT_LT(found, exact * (1 + 1e-12));
  EXPECT_GT(found, 0.95 * exact);
}

TEST(LargestEigenvalue, RefusesAnIndefiniteMatrix) {
  const Eigen::MatrixXd a = -chain(10);
  EXPECT_ERROR(largest_eigenvalue(times(a), times(Eigen::MatrixXd::Identity(30, 30)), SharedRows(10), 5),
               ErrorCode::singular_system, "not positive definite");
}

TEST(Chebyshev, IsTheSmallestPolynomialOnItsInterval) {
  // For a diagonal matrix every eigenvalue's error is T_k((b + a - 2 t) / (b - a)) / T_k((b + a) / (b - a)).
  const double low = 1;
  const double high = 9;
  for (int degree = 1; degree <= 5; ++degree) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(9, low, high);
    const Eigen::MatrixXd diagonal = t.asDiagonal();
    const Eigen::VectorXd x = chebyshev(times(diagonal), times(Eigen::MatrixXd::Identity(9, 9)),
                                        Eigen::VectorXd::Ones(9), {low, high, degree});
    for (int i = 0; i < 9; ++i) {
      const double at = std::clamp((high + low - 2 * t[i]) / (high - low), -1.0, 1.0);
      const double expected =
          std::cos(degree * std::acos(at)) / std::cosh(degree * std::acosh((high + low) / (high - low)));
      EXPECT_NEAR(1 - t[i] * x[i], expected, 1e-13);
    }
  }
}

TEST(Multigrid, IsSymmetricAndPositiveDefinite) {
  const Multigrid multigrid = two_grids(10);
  Eigen::MatrixXd m(63, 63);
  for (int i = 0; i < 63; ++i) m.col(i) = multigrid.apply(Eigen::VectorXd::Unit(63, i));
  EXPECT_LT((m - m.transpose()).norm(), 1e-12 * m.norm());
  EXPECT_GT(symmetric_eigenvalues(m).minCoeff<Eigen::PropagateNaN>(), 0);
}

// Columns that go through the cycle together, on levels with and without products of several vectors.
TEST(Multigrid, TakesSeveralResidualsAtOnce) {
  const Multigrid multigrid = two_grids(10);
  const Eigen::MatrixXd residuals = Eigen::MatrixXd::NullaryExpr(
      63, 4, [](Eigen::Index i, Eigen::Index j) { return std::sin(static_cast<double>(3 * i + 7 * j)); });
  const Eigen::MatrixXd found = multigrid.apply_each(residuals);
  for (Eigen::Index j = 0; j < residuals.cols(); ++j)
    EXPECT_LT((found.col(j) - multigrid.apply(residuals.col(j))).norm(), 1e-14 * found.col(j).norm());
}

TEST(VectorsOperator, UsesWhatItKnowsOfSeveralVectors) {
  const VectorsOperator twice = {[](const Eigen::VectorXd& x) { return Eigen::VectorXd(2 * x); },
                                 [](const Eigen::MatrixXd& x) { return Eigen::MatrixXd(2.5 * x); }};
  EXPECT_EQ(twice.of_each(Eigen::MatrixXd::Ones(3, 2)), Eigen::MatrixXd::Constant(3, 2, 2.5));
  EXPECT_EQ(twice.of_each(Eigen::MatrixXd::Ones(3, 1)), Eigen::MatrixXd::Constant(3, 1, 2));
  const VectorsOperator alone = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(2 * x); };
  EXPECT_EQ(alone.of_each(Eigen::MatrixXd::Ones(3, 2)), Eigen::MatrixXd::Constant(3, 2, 2));
  const VectorsOperator first = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.head(1)); };
  EXPECT_EQ(first.of_each(Eigen::MatrixXd::Ones(3, 2)), Eigen::MatrixXd::Ones(1, 2));
  EXPECT_TRUE(alone);
  EXPECT_FALSE(VectorsOperator());
}

TEST(Multigrid, KeepsIterationsBoundedAsTheChainGrows) {
  std::vector<int> iterations;
  for (const int coarse : {10, 40, 160}) {
    const Multigrid multigrid = two_grids(coarse);
    const int fine = 2 * coarse + 1;
    const Eigen::MatrixXd a = chain(fine);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(3 * fine, -1, 2);
    const LinearSolution s = solve_with_cg(
        {SharedRows(fine), times(a), [&](const Eigen::VectorXd& r) { return multigrid.apply(r); }, load},
        {.tolerance = 1e-10}, {});
    EXPECT_LT((a * s.x - load).norm(), 1e-8 * load.norm());
    EXPECT_LE(s.report.energy_error, 1e-10);
    iterations.push_back(s.report.iterations);
  }
  EXPECT_LE(iterations[2], iterations[0] + 3);
}

TEST(MinimalResiduals, SolveASaddlePoint) {
  const int n = 30;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * n + 3, 3 * n + 3);
  a.topLeftCorner(3 * n, 3 * n) = chain(n);
  for (int c = 0; c < 3; ++c) {
    a(3 * n + c, c) = a(c, 3 * n + c) = 1;
    a(3 * n + c, 3 * n - 3 + c) = a(3 * n - 3 + c, 3 * n + c) = -1;
  }
  Eigen::MatrixXd m = Eigen::MatrixXd::Identity(3 * n + 3, 3 * n + 3);
  m.topLeftCorner(3 * n, 3 * n) = pseudo_inverse(chain(n));
  Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(3 * n + 3, 1, 5);
  const LinearSolution s =
      solve_with_minres({SharedRows(n + 1), times(a), times(m), load}, {.tolerance = 1e-11}, {});
  EXPECT_LT((a * s.x - load).norm(), 1e-8 * load.norm());
  EXPECT_EQ(s.report.method, Method::minres);
}

TEST(ConjugateGradients, SayHowFarTheyCameWhereTheyDoNotConverge) {
  const Eigen::MatrixXd a = chain(200);
  try {
    solve_with_cg({SharedRows(200), times(a), inverse_diagonal(a), Eigen::VectorXd::Ones(600)},
                  {.tolerance = 1e-10, .max_iterations = 3}, {});
    FAIL() << "three iterations cannot be enough";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::not_converged);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("after 3 iterations"));
  }
}

}  // namespace
}  // namespace isopatch::solvers
