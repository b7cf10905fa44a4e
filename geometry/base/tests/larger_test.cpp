#include "geometry/base/larger.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace isopatch {
namespace {

TEST(Larger, IsNanIfEitherIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(larger(1.0, 2.0), 2);
  EXPECT_EQ(larger(2.0, 1.0), 2);
  EXPECT_EQ(larger(3, -1), 3);
  EXPECT_TRUE(std::isnan(larger(nan, 1.0)));
  EXPECT_TRUE(std::isnan(larger(1.0, nan)));
  EXPECT_TRUE(std::isnan(larger(-std::numeric_limits<double>::infinity(), nan)));
}

TEST(Smaller, IsNanIfEitherIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(smaller(1.0, 2.0), 1);
  EXPECT_EQ(smaller(2.0, 1.0), 1);
  EXPECT_EQ(smaller(3, -1), -1);
  EXPECT_TRUE(std::isnan(smaller(nan, 1.0)));
  EXPECT_TRUE(std::isnan(smaller(1.0, nan)));
  EXPECT_TRUE(std::isnan(smaller(std::numeric_limits<double>::infinity(), nan)));
}

// What tests and claims rely on for matrices, wherever the NaN is and whether or not Eigen vectorizes.
TEST(Larger, EigenTellsNanAtEveryPlace) {
  for (int n : {1, 2, 3, 7, 16, 64}) {
    for (int at = 0; at < n; ++at) {
      Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(n, -1, 5);
      values[at] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_TRUE(std::isnan(values.cwiseAbs().maxCoeff<Eigen::PropagateNaN>())) << n << " " << at;
      EXPECT_TRUE(std::isnan(values.minCoeff<Eigen::PropagateNaN>())) << n << " " << at;
      const Eigen::Matrix3Xd columns = values.transpose().replicate(3, 1);
      EXPECT_TRUE(std::isnan(columns.colwise().norm().maxCoeff<Eigen::PropagateNaN>())) << n << " " << at;
    }
  }
}

}  // namespace
}  // namespace isopatch
