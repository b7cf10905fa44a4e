#include <gtest/gtest.h>

#include <cstdlib>

#include "solvers/internal/blas_symbol.hpp"

namespace isopatch::solvers {
namespace {

// The libraries have read the settings before any test; only who set nothing himself sees ours.
TEST(Waiting, SettingsAreThereWhereTheUserHasNone) {
  ::setenv("OMP_WAIT_POLICY", "active", 1);
  EXPECT_STREQ(std::getenv("OMP_WAIT_POLICY"), "active");
  ::unsetenv("OMP_WAIT_POLICY");
  EXPECT_STREQ(std::getenv("OMP_WAIT_POLICY"), "passive");
  EXPECT_EQ(std::getenv("ISOPATCH_NO_SUCH_VARIABLE"), nullptr);
}

TEST(Waiting, OpenBlasHasReadItsOwn) {
  auto* const timeout = blas_function<int()>("openblas_thread_timeout");
  if (timeout == nullptr) GTEST_SKIP() << "the BLAS is not OpenBLAS";
  EXPECT_EQ(timeout(), std::atoi(std::getenv("OPENBLAS_THREAD_TIMEOUT")));
}

}  // namespace
}  // namespace isopatch::solvers
