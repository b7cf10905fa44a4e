#include "solvers/zeroed_allocator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace isopatch::solvers {
namespace {

TEST(ZeroedVector, IsZeroOnTheHeapAndInMappedPages) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{1} << 20}) {
    for (int again = 0; again < 2; ++again) {
      ZeroedVector<double> vector(size);
      EXPECT_TRUE(std::all_of(vector.begin(), vector.end(), [](double x) { return x == 0; })) << size;
      std::fill(vector.begin(), vector.end(), 3.0);  // the heap may give the same memory again
    }
  }
}

TEST(ZeroedVector, IsAVectorLikeAnyOther) {
  ZeroedVector<double> vector;
  for (int i = 0; i < 1 << 20; ++i) vector.push_back(i);
  const ZeroedVector<double> copy = vector;
  EXPECT_EQ(copy, vector);
  EXPECT_EQ(copy.back(), (1 << 20) - 1);
  vector.assign(5, 2.5);
  EXPECT_EQ(vector, ZeroedVector<double>({2.5, 2.5, 2.5, 2.5, 2.5}));
}

}  // namespace
}  // namespace isopatch::solvers
