#include "solvers/blas_core.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace isopatch::solvers {
namespace {

TEST(BlasCore, IsReplacedWhereTheCpuCanDoMore) {
  EXPECT_EQ(better_blas_core("Prescott", {.avx2 = true, .avx512 = true}), "SkylakeX");
  EXPECT_EQ(better_blas_core("Prescott", {.avx2 = true}), "Haswell");
  EXPECT_EQ(better_blas_core("Sandybridge", {.avx2 = true}), "Haswell");
  EXPECT_EQ(better_blas_core("Barcelona", {.avx2 = true, .avx512 = true}), "SkylakeX");
  EXPECT_EQ(better_blas_core("Prescott", {}), "");
}

TEST(BlasCore, StaysWhereTheLibraryKnowsTheCpu) {
  for (const char* core : {"Haswell", "Zen", "SkylakeX", "Cooperlake", "SapphireRapids", "neoversen1", ""})
    EXPECT_EQ(better_blas_core(core, {.avx2 = true, .avx512 = true}), "") << core;
}

TEST(BlasCore, InUseIsTheBestOneForThisCpu) {
  if (blas_core().empty()) GTEST_SKIP() << "the BLAS is not OpenBLAS";
  if (std::getenv("OPENBLAS_CORETYPE") != nullptr) GTEST_SKIP() << "OPENBLAS_CORETYPE chooses";
  EXPECT_EQ(better_blas_core(blas_core(), cpu_features()), "") << blas_core();
}

}  // namespace
}  // namespace isopatch::solvers
