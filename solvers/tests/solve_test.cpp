#include "solvers/solve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr Method spd_methods[] = {Method::cholmod, Method::mumps, Method::umfpack, Method::cg};
constexpr Method saddle_methods[] = {Method::mumps, Method::umfpack};

// A method as `solve` takes it: conjugate gradients have no preconditioner there but one.
SolverOptions by(Method method, double tolerance = 1e-10, int max_iterations = 10000) {
  SolverOptions options;
  options.method = method;
  options.tolerance = tolerance;
  options.max_iterations = max_iterations;
  if (method == Method::cg) options.preconditioner = Preconditioner::block_jacobi;
  return options;
}

LinearSystem random_spd_system(int rows, unsigned seed) {
  std::mt19937 random(seed);
  return {from_dense(random_spd(rows, random)), {}, random_matrix(rows, 1, random)};
}

// K is singular, and positive definite on the kernel of B.
LinearSystem random_saddle_system(int rows, int multipliers, unsigned seed) {
  std::mt19937 random(seed);
  const Eigen::MatrixXd a = random_matrix(rows, rows - multipliers, random);
  return {from_dense(a * a.transpose()), sparse(random_matrix(multipliers, rows, random)),
          random_matrix(rows, 1, random)};
}

struct DenseSolution {
  Eigen::VectorXd x, y;
};

DenseSolution dense_solution(const LinearSystem& system) {
  const Eigen::Index n = system.load.size(), m = system.constraints.rows();
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + m, n + m);
  whole.topLeftCorner(n, n) = to_dense(system.stiffness);
  if (m > 0) {
    whole.bottomLeftCorner(m, n) = Eigen::MatrixXd(system.constraints);
    whole.topRightCorner(n, m) = Eigen::MatrixXd(system.constraints).transpose();
  }
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(n + m);
  right_side.head(n) = system.load;
  const Eigen::VectorXd z = solve_by_lu(whole, right_side);
  return {z.head(n), z.tail(m)};
}

double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).norm() / b.norm();
}

/// Code and message of the error that solving ends with.
std::pair<ErrorCode, std::string> failure(const LinearSystem& system, const SolverOptions& options) {
  try {
    solve(system, options);
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {ErrorCode::internal, "nothing was thrown"};
}

TEST(Solve, InvertsADiagonalMatrixExactly) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6, 6);
  dense.diagonal() << 1, 2, 4, 8, 16, 32;
  for (const Method method : spd_methods) {
    const LinearSolution solution = solve({from_dense(dense), {}, dense.diagonal()}, by(method));
    EXPECT_LE((solution.x - Eigen::VectorXd::Ones(6)).norm(), 1e-15) << name(method);
  }
}

// Springs k1 and k2 in a row from a wall, pulled at the end by F: u1 = F / k1, u2 = F / k1 + F / k2.
TEST(Solve, FindsTheStretchOfTwoSprings) {
  constexpr double k1 = 3, k2 = 5, force = 30;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(6, 6);
  dense(0, 0) = k1 + k2;
  dense(0, 3) = dense(3, 0) = -k2;
  dense(3, 3) = k2;
  for (const Method method : spd_methods) {
    const LinearSolution solution =
        solve({from_dense(dense), {}, force * Eigen::VectorXd::Unit(6, 3)}, by(method, 1e-14));
    EXPECT_NEAR(solution.x[0], 10, 1e-13) << name(method);
    EXPECT_NEAR(solution.x[3], 16, 1e-13) << name(method);
  }
}

// The same two springs as separate parts, of which the second floats, tied together by u1 - u2 = 0. The tie
// carries the whole force.
TEST(Solve, FindsTheForceInATie) {
  constexpr double k1 = 3, k2 = 5, force = 30;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(9, 9);
  dense(0, 0) = k1;
  dense(3, 3) = dense(6, 6) = k2;
  dense(3, 6) = dense(6, 3) = -k2;
  Eigen::MatrixXd tie = Eigen::MatrixXd::Zero(1, 9);
  tie(0, 0) = 1;
  tie(0, 3) = -1;
  for (const Method method : saddle_methods) {
    const LinearSolution solution =
        solve({from_dense(dense), sparse(tie), force * Eigen::VectorXd::Unit(9, 6)}, by(method, 1e-13));
    EXPECT_NEAR(solution.x[0], 10, 1e-12) << name(method);
    EXPECT_NEAR(solution.x[3], 10, 1e-12) << name(method);
    EXPECT_NEAR(solution.x[6], 16, 1e-12) << name(method);
    ASSERT_EQ(solution.multipliers.size(), 1);
    EXPECT_NEAR(solution.multipliers[0], -force, 1e-12) << name(method);  // k1 u1 + y = 0
  }
}

TEST(Solve, AgreesWithDenseEigenOnRandomDefiniteSystems) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const LinearSystem system = random_spd_system(3 + 12 * static_cast<int>(seed), seed);
    const Eigen::VectorXd expected = dense_solution(system).x;
    for (const Method method : spd_methods) {
      const LinearSolution solution = solve(system, by(method, 1e-13));
      EXPECT_LE(relative_difference(solution.x, expected), 1e-11) << name(method) << " seed " << seed;
      EXPECT_EQ(solution.multipliers.size(), 0);
    }
  }
}

TEST(Solve, AgreesWithDenseEigenOnRandomSaddleSystems) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const LinearSystem system =
        random_saddle_system(30 + 9 * static_cast<int>(seed), 1 + 3 * static_cast<int>(seed), seed);
    const DenseSolution expected = dense_solution(system);
    for (const Method method : saddle_methods) {
      const LinearSolution solution = solve(system, by(method, 1e-13));
      EXPECT_LE(relative_difference(solution.x, expected.x), 1e-10) << name(method) << " seed " << seed;
      EXPECT_LE(relative_difference(solution.multipliers, expected.y), 1e-10)
          << name(method) << " seed " << seed;
    }
  }
}

TEST(Solve, AllMethodsAgreeOnAGrid) {
  std::mt19937 random(11);
  LinearSystem system{spring_grid({8, 8, 8}, 2, 0.01), {}, {}};
  system.load = random_matrix(system.stiffness.rows(), 1, random);
  const LinearSolution reference = solve(system, by(Method::cholmod));
  for (const Method method : spd_methods) {
    const LinearSolution solution = solve(system, by(method, 1e-13));
    EXPECT_LE(relative_difference(solution.x, reference.x), 1e-10) << name(method);
    EXPECT_LE(solution.report.relative_residual, 1e-13) << name(method);
  }
}

// Several right sides, of very different sizes and one of them zero, are those of solving one by one.
TEST(Solve, SolvesEachOfSeveralLoadsAsAlone) {
  for (const bool saddle : {false, true}) {
    LinearSystem system = saddle ? random_saddle_system(60, 9, 5) : random_spd_system(60, 5);
    std::mt19937 random(17);
    std::vector<Eigen::VectorXd> loads;
    for (const double size : {1.0, 0.0, 1e9, 1e-9})
      loads.emplace_back(size * random_matrix(system.stiffness.rows(), 1, random));
    for (const Method method : saddle
                                   ? std::vector<Method>(std::begin(saddle_methods), std::end(saddle_methods))
                                   : std::vector<Method>(std::begin(spd_methods), std::end(spd_methods))) {
      const std::vector<LinearSolution> together = solve_each(system, loads, by(method, 1e-13));
      ASSERT_EQ(together.size(), loads.size());
      EXPECT_EQ(together[1].x.norm(), 0) << name(method);
      for (const std::size_t i : {0u, 2u, 3u}) {
        system.load = loads[i];
        const LinearSolution alone = solve(system, by(method, 1e-13));
        // The BLAS sums columns of a block in another order; the condition is some 1e3.
        EXPECT_LE(relative_difference(together[i].x, alone.x), 1e-11) << name(method) << ", load " << i;
        if (saddle) {
          EXPECT_LE(relative_difference(together[i].multipliers, alone.multipliers), 1e-11) << name(method);
        }
        EXPECT_LE(together[i].report.relative_residual, 1e-13) << name(method);
        EXPECT_EQ(together[i].report.method, method);
      }
    }
  }
}

TEST(Solve, RefusesOneOfSeveralLoadsThatIsNoNumber) {
  const LinearSystem system = random_spd_system(6, 1);
  Eigen::VectorXd bad = system.load;
  bad[4] = std::nan("");
  try {
    solve_each(system, {system.load, bad}, by(Method::cholmod));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_THAT(error.what(), HasSubstr("block row 1"));
  }
}

TEST(Solve, SaddleMethodsAgreeOnAFloatingGrid) {
  std::mt19937 random(12);
  LinearSystem system{spring_grid({7, 7, 7}, 1, 0), {}, {}};
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(3, system.stiffness.rows());
  held.leftCols<3>().setIdentity();
  system.constraints = sparse(held);
  system.load = random_matrix(system.stiffness.rows(), 1, random);
  const LinearSolution a = solve(system, by(Method::mumps));
  const LinearSolution b = solve(system, by(Method::umfpack));
  EXPECT_LE(relative_difference(a.x, b.x), 1e-10);
  // The reaction balances the load, for the grid floats: y = sum of the loads.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < system.load.size(); i += 3) sum += system.load.segment<3>(i);
  EXPECT_LE(relative_difference(a.multipliers, sum), 1e-10);
  EXPECT_LE(relative_difference(b.multipliers, sum), 1e-10);
}

// Stiffness in N/m of steel beside constraints of order 1: scaling K by s scales x by 1/s and leaves y.
TEST(Solve, MultipliersDoNotDependOnTheUnitOfStiffness) {
  const LinearSystem system = random_saddle_system(45, 9, 21);
  const DenseSolution expected = dense_solution(system);
  for (const double scale : {1e11, 1e-7}) {
    LinearSystem scaled = system;
    for (double& value : scaled.stiffness.values) value *= scale;
    for (const Method method : saddle_methods) {
      const LinearSolution solution = solve(scaled, by(method));
      EXPECT_LE(relative_difference(scale * solution.x, expected.x), 1e-10) << name(method);
      EXPECT_LE(relative_difference(solution.multipliers, expected.y), 1e-10) << name(method);
    }
  }
}

TEST(Solve, TakesLoadsOfManyOrdersOfMagnitude) {
  LinearSystem system = random_spd_system(30, 31);
  for (Eigen::Index i = 0; i < 30; ++i) system.load[i] = std::pow(10.0, static_cast<double>(i) - 15);
  const Eigen::VectorXd expected = dense_solution(system).x;
  for (const Method method : spd_methods)
    EXPECT_LE(relative_difference(solve(system, by(method, 1e-13)).x, expected), 1e-11) << name(method);
}

TEST(Solve, TakesLoadsWhoseSquaresOverflowOrVanish) {
  const LinearSystem system = random_spd_system(30, 32);
  const Eigen::VectorXd expected = dense_solution(system).x;
  for (const double scale : {1e-200, 1e200}) {
    LinearSystem scaled = system;
    scaled.load *= scale;
    for (const Method method : spd_methods)
      EXPECT_LE(relative_difference(solve(scaled, by(method)).x / scale, expected), 1e-9) << name(method);
  }
}

TEST(Solve, ZeroLoadGivesZero) {
  LinearSystem definite = random_spd_system(12, 41), saddle = random_saddle_system(12, 2, 41);
  definite.load.setZero();
  saddle.load.setZero();
  for (const Method method : spd_methods) {
    const LinearSolution solution = solve(definite, by(method));
    EXPECT_TRUE(solution.x.size() == 12 && solution.x.isZero(0));
    EXPECT_EQ(solution.report.method, method);
  }
  for (const Method method : saddle_methods) {
    const LinearSolution solution = solve(saddle, by(method));
    EXPECT_TRUE(solution.x.size() == 12 && solution.x.isZero(0));
    EXPECT_TRUE(solution.multipliers.size() == 2 && solution.multipliers.isZero(0));
  }
}

TEST(Solve, NothingToSolveGivesNothing) {
  for (const Method method : spd_methods) EXPECT_EQ(solve({}, by(method)).x.size(), 0);
}

TEST(Solve, ReportsWhatItDid) {
  const LinearSystem system = random_spd_system(30, 51);
  for (const Method method : spd_methods) {
    const SolveReport report = solve(system, by(method)).report;
    EXPECT_EQ(report.method, method);
    EXPECT_EQ(report.reason, "");
    EXPECT_EQ(report.matrix_nonzeros, 900);
    EXPECT_EQ(report.residual_history.size(), static_cast<std::size_t>(report.iterations) + 1);
    EXPECT_LE(report.relative_residual, 1e-10);
    EXPECT_GT(report.memory_bytes, 8 * 30);
    if (report.method == Method::cg) {
      EXPECT_EQ(report.residual_history.front(), 1);
      EXPECT_EQ(report.factor_nonzeros, 0);
    } else {
      EXPECT_GE(report.factor_nonzeros, 465);  // the lower triangle of a full matrix of 30 rows
      EXPECT_GT(report.factor_flops, 1000);
    }
  }
}

TEST(Solve, TellsItsProgress) {
  const LinearSystem system = random_spd_system(30, 52);
  for (const Method method : spd_methods) {
    std::vector<std::string> phases;
    solve(system, by(method), {[&](std::string_view phase, double share) {
            EXPECT_TRUE(share >= 0 && share <= 1);
            phases.emplace_back(phase);
          }});
    EXPECT_THAT(phases, ::testing::Contains(method == Method::cg ? "iterations" : "factorization"));
  }
}

TEST(Solve, AnExceptionOfTheListenerComesOut) {
  const LinearSystem system = random_spd_system(30, 53);
  for (const Method method : spd_methods)
    EXPECT_THROW(solve(system, by(method), {[](std::string_view, double share) {
                         if (share >= 0) throw std::range_error("enough");
                       }}),
                 std::range_error);
  EXPECT_LE(solve(system, by(Method::cg)).report.relative_residual, 1e-10);  // and PETSc still works
}

TEST(Solve, FreeGridIsSingularForEveryMethod) {
  std::mt19937 random(61);
  LinearSystem system{spring_grid({6, 6, 6}, 1, 0), {}, {}};
  system.load = random_matrix(system.stiffness.rows(), 1, random);
  for (const Method method : {Method::cholmod, Method::mumps, Method::umfpack}) {
    const auto [code, message] = failure(system, by(method));
    EXPECT_EQ(code, ErrorCode::singular_system) << name(method) << ": " << message;
  }
  const ErrorCode code = failure(system, by(Method::cg, 1e-10, 500)).first;
  EXPECT_TRUE(code == ErrorCode::singular_system || code == ErrorCode::not_converged);
}

// A load in balance has solutions all the same; a direct method must not pick one.
TEST(Solve, FreeGridIsSingularAlsoUnderALoadInBalance) {
  LinearSystem system{spring_grid({6, 6, 6}, 1, 0), {}, {}};
  system.load =
      Eigen::VectorXd::Unit(system.stiffness.rows(), 0) - Eigen::VectorXd::Unit(system.stiffness.rows(), 300);
  for (const Method method : {Method::cholmod, Method::mumps, Method::umfpack})
    EXPECT_EQ(failure(system, by(method)).first, ErrorCode::singular_system) << name(method);
}

TEST(Solve, AnEmptyRowIsSingularAndNamedByItsBlock) {
  std::mt19937 random(62);
  Eigen::MatrixXd dense = random_spd(12, random);
  dense.row(7).setZero();
  dense.col(7).setZero();
  const LinearSystem system{from_dense(dense), {}, Eigen::VectorXd::Ones(12)};
  for (const Method method : spd_methods)
    EXPECT_EQ(failure(system, by(method)).first, ErrorCode::singular_system) << name(method);
  EXPECT_THAT(failure(system, by(Method::cholmod)).second, HasSubstr("at block row 2, component 1"));
  EXPECT_THAT(failure(system, by(Method::cg)).second, HasSubstr("diagonal block 2"));
}

TEST(Solve, RepeatedConstraintsAreSingular) {
  LinearSystem system = random_saddle_system(30, 4, 63);
  Eigen::MatrixXd constraints = system.constraints;
  constraints.row(3) = constraints.row(0) - 2 * constraints.row(1);
  system.constraints = sparse(constraints);
  for (const Method method : saddle_methods)
    EXPECT_EQ(failure(system, by(method)).first, ErrorCode::singular_system) << name(method);
}

TEST(Solve, ConstraintsThatLeaveAMotionAreSingular) {
  std::mt19937 random(64);
  LinearSystem system{spring_grid({5, 5, 5}, 1, 0), {}, {}};
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(2, system.stiffness.rows());
  held.leftCols<2>().setIdentity();  // the third direction stays free
  system.constraints = sparse(held);
  system.load = random_matrix(system.stiffness.rows(), 1, random);
  for (const Method method : saddle_methods)
    EXPECT_EQ(failure(system, by(method)).first, ErrorCode::singular_system) << name(method);
}

TEST(Solve, IndefiniteStiffnessIsRefused) {
  std::mt19937 random(65);
  const Eigen::MatrixXd dense =
      random_spd(12, random) - 20 * Eigen::VectorXd::Unit(12, 4).asDiagonal().toDenseMatrix();
  const LinearSystem system{from_dense(dense), {}, Eigen::VectorXd::Ones(12)};
  for (const Method method : {Method::cholmod, Method::mumps, Method::cg})
    EXPECT_EQ(failure(system, by(method)).first, ErrorCode::singular_system) << name(method);
  EXPECT_THAT(failure(system, by(Method::mumps)).second, HasSubstr("1 negative pivots instead of 0"));
}

// A row of springs whose far end moves (n / 1)^3-like far: condition 1e12, and no singular matrix.
TEST(Solve, AStiffAndASoftPartAreNotTakenForSingular) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(6, 6);
  constexpr double stiff = 1e9;
  dense(0, 0) = 1 + stiff;
  dense(0, 3) = dense(3, 0) = -stiff;
  dense(3, 3) = stiff;
  const LinearSystem system{from_dense(dense), {}, Eigen::VectorXd::Unit(6, 3)};
  for (const Method method : {Method::cholmod, Method::mumps, Method::umfpack}) {
    const LinearSolution solution = solve(system, by(method));
    EXPECT_NEAR(solution.x[0], 1, 1e-6) << name(method);  // (1 + stiff) - stiff keeps 7 digits
  }
}

TEST(Solve, NotConvergedIsAnErrorWithAdvice) {
  std::mt19937 random(71);
  LinearSystem system{spring_grid({8, 8, 8}, 1, 1e-4), {}, {}};
  system.load = random_matrix(system.stiffness.rows(), 1, random);
  const auto [code, message] = failure(system, by(Method::cg, 1e-10, 5));
  EXPECT_EQ(code, ErrorCode::not_converged);
  EXPECT_THAT(message, AllOf(HasSubstr("'cg'"), HasSubstr("after 5 iterations"),
                             HasSubstr("raise max_iterations"), HasSubstr("cholmod")));
}

TEST(Solve, RefusesOptionsOutOfRange) {
  const LinearSystem system = random_spd_system(6, 81);
  for (const double tolerance : {0.0, -1.0, 0.5, std::nan("")}) {
    const auto [code, message] = failure(system, {.tolerance = tolerance});
    EXPECT_EQ(code, ErrorCode::invalid_argument);
    EXPECT_THAT(message, AllOf(HasSubstr("tolerance"), HasSubstr("[1e-14, 1e-2]")));
  }
  for (const int iterations : {0, -3, 10'000'001}) {
    const auto [code, message] = failure(system, {.max_iterations = iterations});
    EXPECT_EQ(code, ErrorCode::invalid_argument);
    EXPECT_THAT(message, AllOf(HasSubstr("max_iterations"), HasSubstr("10000000")));
  }
  const auto why = [&](const SolverOptions& options) { return failure(system, options).second; };
  EXPECT_THAT(why({.memory_limit = -1}), HasSubstr("memory_limit is -1 bytes; it must be positive"));
  EXPECT_THAT(why({.multigrid = {.smoothing_degree = 0}}),
              HasSubstr("smoothing_degree is 0; it must lie in 1 .. 20"));
  EXPECT_THAT(why({.multigrid = {.smoothing_range = 1}}),
              HasSubstr("smoothing_range is 1; it must lie in [1.1, 1000]"));
}

TEST(Solve, RefusesToChooseWhatItCannotForecast) {
  const auto [code, message] = failure(random_spd_system(6, 85), {});
  EXPECT_EQ(code, ErrorCode::invalid_argument);
  EXPECT_THAT(message, AllOf(HasSubstr("'auto'"), HasSubstr("'cholmod'"), HasSubstr("'mumps'")));
}

TEST(Solve, RefusesMinimalResidualsForAMatrixAlone) {
  EXPECT_THAT(failure(random_spd_system(6, 85), {.method = Method::minres}).second, HasSubstr("multigrid"));
}

TEST(Solve, RefusesConstraintsWhereTheMethodCannotTreatThem) {
  const LinearSystem system = random_saddle_system(12, 2, 82);
  for (const Method method : {Method::cholmod, Method::cg}) {
    const auto [code, message] = failure(system, by(method));
    EXPECT_EQ(code, ErrorCode::invalid_argument);
    EXPECT_THAT(message, AllOf(HasSubstr(std::string(name(method))), HasSubstr("'mumps'")));
  }
}

TEST(Solve, RefusesWhatIsNotANumber) {
  const LinearSystem good = random_saddle_system(12, 2, 83);
  for (const double bad_value : {std::nan(""), HUGE_VAL}) {
    LinearSystem bad = good;
    bad.stiffness.values[9 * 2 + 4] = bad_value;
    EXPECT_THAT(failure(bad, {}).second, HasSubstr("block row 0, block column 2"));
    bad = good;
    bad.load[7] = bad_value;
    EXPECT_THAT(failure(bad, {}).second,
                HasSubstr("load is not a number or infinite at block row 2, component 1"));
    bad = good;
    bad.constraints.coeffRef(1, 5) = bad_value;
    EXPECT_THAT(failure(bad, {}).second, HasSubstr("row 1, column 5"));
    EXPECT_EQ(failure(bad, {}).first, ErrorCode::invalid_argument);
  }
}

TEST(Solve, RefusesSizesThatDoNotFit) {
  LinearSystem bad = random_saddle_system(12, 2, 84);
  bad.load.conservativeResize(11);
  EXPECT_THAT(failure(bad, {}).second, HasSubstr("load has 11 entries, the matrix 12 rows"));
  bad = random_saddle_system(12, 2, 84);
  bad.constraints = sparse(Eigen::MatrixXd::Ones(2, 9));
  EXPECT_THAT(failure(bad, {}).second, HasSubstr("constraints have 9 columns"));
  bad = random_saddle_system(12, 2, 84);
  std::swap(bad.stiffness.columns[1], bad.stiffness.columns[2]);
  EXPECT_THAT(failure(bad, {}).second, HasSubstr("block row 0: column 1 is out of order"));
  bad = random_saddle_system(12, 2, 84);
  bad.stiffness.columns[0] = 1;
  EXPECT_THAT(failure(bad, {}).second, HasSubstr("does not start with its diagonal block"));
}

TEST(Solve, RefusesWhatAMatrixAloneCannotGive) {
  const LinearSystem system = random_spd_system(12, 86);
  EXPECT_THAT(failure(system, {.method = Method::cg}).second, HasSubstr("preconditioner 'multigrid'"));
  SolverOptions free = by(Method::cholmod);
  free.form = Operator::matrix_free;
  EXPECT_THAT(failure(system, free).second, HasSubstr("operator 'matrix_free'"));
}

TEST(Method, NamesAreThoseOfTheStudyFile) {
  EXPECT_EQ(name(Method::automatic), "auto");
  EXPECT_EQ(name(Method::cholmod), "cholmod");
  EXPECT_EQ(name(Method::mumps), "mumps");
  EXPECT_EQ(name(Method::umfpack), "umfpack");
  EXPECT_EQ(name(Method::cg), "cg");
}

}  // namespace
}  // namespace isopatch::solvers
