#include "solvers/memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <vector>

namespace isopatch::solvers {
namespace {

TEST(AvailableMemory, FollowsTheLimitOnTheAddressSpace) {
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const std::int64_t free = available_memory();
  ASSERT_GT(free, 0);
  // The process has this much mapped already, so nothing can be left of it.
  const rlimit tight = {static_cast<rlim_t>(resident_memory()), before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
  const std::int64_t left = available_memory();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_EQ(left, 1);
}

TEST(ResidentMemory, GrowsWithWhatIsTouched) {
  // A busy system may take other pages of the process away meanwhile; hardly each time.
  bool has_grown = false;
  for (int attempt = 0; attempt < 5; ++attempt) {
    const std::int64_t before = resident_memory();
    const std::vector<double> touched(std::size_t{8} << 20, 1.0);
    has_grown = has_grown || resident_memory() - before > std::int64_t{60} << 20;
    EXPECT_EQ(touched.back(), 1.0);
  }
  EXPECT_TRUE(has_grown);
}

}  // namespace
}  // namespace isopatch::solvers
