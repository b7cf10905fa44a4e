#include "solvers/block_lanczos.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include "geometry/base/tests/expect_error.hpp"
#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A pencil K x = lambda M x with known eigenvalues, in a random basis.
struct Pencil {
  Pencil(const VectorXd& values, unsigned seed) {
    std::mt19937 random(seed);
    const auto n = static_cast<int>(values.size());
    const MatrixXd basis = random_matrix(n, n, random) + 3 * MatrixXd::Identity(n, n);
    mass = basis.transpose() * basis;
    stiffness = basis.transpose() * values.asDiagonal() * basis;
  }
  EigenPairs largest(const LanczosOptions& options, int block, double shift = 0) const {
    std::mt19937 random(5);
    const Eigen::LLT<MatrixXd> factors(stiffness + shift * mass);
    return largest_eigenpairs([&](const MatrixXd& x) -> MatrixXd { return factors.solve(mass * x); },
                              [&](const MatrixXd& x) -> MatrixXd { return mass * x; },
                              random_matrix(static_cast<int>(mass.rows()), block, random), options);
  }
  MatrixXd stiffness, mass;
};

VectorXd sixty() {
  VectorXd values = VectorXd::LinSpaced(60, 10, 1000);
  values.head(9) << 1, 2, 2, 2, 3, 4, 4, 5, 6;
  return values;
}

// Cholesky factors of such a matrix, of condition 1e6, solve to this.
constexpr double of_factors = 1e-7;

TEST(BlockLanczos, FindsEveryCopy) {
  const Pencil pencil(sixty(), 2);
  const EigenPairs found = pencil.largest({.count = 8}, 4);
  ASSERT_GE(found.values.size(), 8);
  for (Eigen::Index i = 0; i < 8; ++i) EXPECT_NEAR(1 / found.values[i], sixty()[i], of_factors) << i;
  const MatrixXd gram = found.vectors.transpose() * pencil.mass * found.vectors;
  EXPECT_LE((gram - MatrixXd::Identity(gram.rows(), gram.rows())).norm(), 1e-9);
  EXPECT_LT(found.applications, 60) << "without the whole space";
}

// A free body: zeros, made definite by a shift.
TEST(BlockLanczos, FindsZerosByAShift) {
  VectorXd values = sixty();
  values.head(6).setZero();
  const EigenPairs found = Pencil(values, 3).largest({.count = 8}, 8, 1);
  for (Eigen::Index i = 0; i < 8; ++i) EXPECT_NEAR(1 / found.values[i] - 1, values[i], of_factors) << i;
}

TEST(BlockLanczos, GivesTheWholeSpaceWhereThatIsAskedFor) {
  const EigenPairs found = Pencil(sixty().head(12), 4).largest({.count = 12, .most_vectors = 12}, 4);
  ASSERT_EQ(found.values.size(), 12);
  EXPECT_NEAR(1 / found.values[11], sixty()[11], 1e3 * of_factors);
}

TEST(BlockLanczos, SaysHowManyHaveConverged) {
  EXPECT_ERROR(Pencil(sixty(), 2).largest({.count = 20, .most_vectors = 24}, 4), ErrorCode::not_converged,
               "of 20 eigenvalues have converged with 24 vectors");
}

}  // namespace
}  // namespace isopatch::solvers
