#include <gtest/gtest.h>

#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "solvers/operator_system.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/shared_rows.hpp"
#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A x = b with A = 2 I, and one value in the product, the preconditioner or the load that is no number.
OperatorSystem doubled(double in_product, double in_preconditioner, double in_load) {
  OperatorSystem system;
  system.rows = SharedRows(3);
  system.load = Eigen::VectorXd::Ones(9);
  system.load[4] = in_load;
  system.product = [=](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::VectorXd y = 2 * x;
    y[4] *= in_product;
    return y;
  };
  system.preconditioner = [=](const Eigen::VectorXd& r) -> Eigen::VectorXd {
    Eigen::VectorXd y = 0.4 * r;
    y[4] *= in_preconditioner;
    return y;
  };
  return system;
}

// The square of a norm was held above 0 by std::max(0, square), which makes 0 of what is no number.
TEST(NotANumber, IsNoSolutionOfAnIteration) {
  EXPECT_NEAR(solve_with_cg(doubled(1, 1, 1), {}, {}).x[4], 0.5, 1e-9);
  EXPECT_ERROR(solve_with_cg(doubled(nan, 1, 1), {}, {}), ErrorCode::not_converged,
               "reached a relative error of");
  EXPECT_ERROR(solve_with_cg(doubled(1, nan, 1), {}, {}), ErrorCode::not_converged, "that is not a number");
  EXPECT_ERROR(solve_with_cg(doubled(1, 1, nan), {}, {}), ErrorCode::not_converged, "that is not a number");
  EXPECT_ERROR(solve_with_minres(doubled(1, nan, 1), {}, {}), ErrorCode::not_converged,
               "that is not a number");
}

// In each place: Eigen's largest coefficient, and with it the stable norm, passes over some.
TEST(NotANumber, IsInEveryNormOfAVectorThatHasIt) {
  const LinearSystem system{from_dense(Eigen::MatrixXd::Identity(21, 21)), {}, Eigen::VectorXd::Ones(21)};
  for (Eigen::Index i = 0; i < 21; ++i) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(21);
    x[i] = nan;
    EXPECT_TRUE(std::isnan(SharedRows(7).norm(x))) << i;
    EXPECT_TRUE(std::isnan(ScaledSystem(system).norm(x))) << i;
    EXPECT_TRUE(std::isnan(ScaledSystem(system).relative_residual(x))) << i;
  }
}

// Where forces cancel, no vector of doubles comes below what rounding it leaves: that is a solution.
TEST(RoundingLevel, IsWhereAnIterationMayEndAboveItsTolerance) {
  constexpr double stiff = 1e9;
  OperatorSystem system;
  system.rows = SharedRows(2);
  system.load = Eigen::VectorXd::Unit(6, 3);
  system.product = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::VectorXd y = x;
    const double spring = stiff * (x[0] - x[3]);
    y[0] += spring;
    y[3] = -spring;
    return y;
  };
  system.preconditioner = [](const Eigen::VectorXd& r) -> Eigen::VectorXd { return r; };
  const LinearSolution solution = solve_with_cg(system, {}, {});
  EXPECT_NEAR(solution.x[0], 1, 1e-6);
  EXPECT_NE(solution.report.reason.find("double precision"), std::string::npos) << solution.report.reason;
}

}  // namespace
}  // namespace isopatch::solvers
