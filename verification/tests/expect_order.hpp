#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace isopatch::verification {

/// Expects the errors to fall with the given order between every two levels, neither slower nor faster.
/// Needs four levels, and refuses errors below 1e-11, where round-off decides.
inline void expect_order(const std::vector<double>& sizes, const std::vector<double>& errors, double order,
                         double tolerance) {
  ASSERT_GE(sizes.size(), 4u);
  ASSERT_EQ(sizes.size(), errors.size());
  ASSERT_LE(tolerance, 0.2);
  for (std::size_t i = 0; i < errors.size(); ++i)
    ASSERT_GT(errors[i], 1e-11) << "level " << i << " is near round-off";
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double measured = std::log(errors[i - 1] / errors[i]) / std::log(sizes[i - 1] / sizes[i]);
    EXPECT_NEAR(measured, order, tolerance) << "between levels " << i - 1 << " and " << i;
  }
}

}  // namespace isopatch::verification
