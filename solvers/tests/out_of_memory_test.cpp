#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <fstream>

#include "geometry/base/error.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/solve.hpp"
#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

/// Allows the process `bytes` of address space more than it has.
void limit_memory(std::int64_t bytes) {
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const auto limit = static_cast<rlim_t>(pages * 4096 + bytes);
  const rlimit limits = {limit, RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &limits);
}

[[noreturn]] void solve_and_exit_with_the_code(const LinearSystem& system, Method method) {
  limit_memory(3 * system.stiffness.bytes());
  try {
    solve(system, {.method = method});
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", isopatch::name(error.code()), error.what());
    std::_Exit(3);
  }
  std::_Exit(0);
}

// The factors of this grid take ten times the memory of its matrix.
TEST(SolveDeathTest, TooLittleMemoryIsAnErrorThatNamesTheBytes) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs unlimited address space";
#endif
  LinearSystem system{spring_grid({16, 16, 16}, 1, 1), {}, {}};
  system.load = Eigen::VectorXd::Ones(system.stiffness.rows());
  for (const Method method : {Method::cholmod, Method::umfpack})
    EXPECT_EXIT(solve_and_exit_with_the_code(system, method), ::testing::ExitedWithCode(3),
                "out_of_memory: .* [0-9]+ bytes")
        << name(method);
}

}  // namespace
}  // namespace isopatch::solvers
