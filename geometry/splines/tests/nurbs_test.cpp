#include "geometry/splines/nurbs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/splines/bernstein.hpp"
#include "geometry/splines/tests/random_nurbs.hpp"

namespace isopatch::geometry {
namespace {

using ::testing::HasSubstr;

NurbsCurve quarter_circle() {
  Eigen::Matrix3Xd points(3, 3);
  points << 1, 1, 0, 0, 1, 1, 0, 0, 0;
  return NurbsCurve({KnotVector::bezier(2)}, points, Eigen::Vector3d(1, std::sqrt(0.5), 1));
}

std::string refusal(Eigen::Matrix3Xd points, const Eigen::VectorXd& weights) {
  try {
    NurbsCurve({KnotVector::bezier(2)}, std::move(points), weights);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "accepted";
}

TEST(Nurbs, RefusesWrongCountsAndValues) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix3Xd good = Eigen::Matrix3Xd::Random(3, 3);
  const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
  EXPECT_THAT(refusal(Eigen::Matrix3Xd::Random(3, 4), Eigen::Vector4d::Ones()),
              HasSubstr("4 control points"));
  EXPECT_THAT(refusal(good, Eigen::Vector2d::Ones()), HasSubstr("2 weights for 3 control points"));
  EXPECT_THAT(refusal(good, Eigen::Vector3d(1, 0, 1)), HasSubstr("weight 1 is 0"));
  EXPECT_THAT(refusal(good, Eigen::Vector3d(1, 1, -2)), HasSubstr("weight 2 is -2"));
  EXPECT_THAT(refusal(good, Eigen::Vector3d(nan, 1, 1)), HasSubstr("weight 0 is nan"));
  Eigen::Matrix3Xd bad = good;
  bad(1, 2) = nan;
  EXPECT_THAT(refusal(bad, ones), HasSubstr("control point 2 is not finite"));
  bad(1, 2) = -std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(bad, ones), HasSubstr("control point 2 is not finite"));
}

TEST(Nurbs, IsTheUnitCubeByDefault) {
  const NurbsVolume cube;
  const Parameter<3> at(0.2, 0.3, 0.7);
  EXPECT_LT((cube.point(at) - at).norm(), 1e-15);
  EXPECT_LT((cube.jacobian(at) - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(Nurbs, DrawsAnExactCircle) {
  const NurbsCurve arc = quarter_circle();
  for (double t = 0; t <= 1; t += 0.0625) {
    const Parameter<1> at(t);
    const Eigen::Vector3d x = arc.point(at);
    const Eigen::Vector3d d1 = arc.derivative(at, {1});
    const Eigen::Vector3d d2 = arc.derivative(at, {2});
    const Eigen::Vector3d d3 = arc.derivative(at, {3});
    EXPECT_NEAR(x.norm(), 1, 1e-15);
    // |x|^2 = 1 differentiated once, twice and three times.
    EXPECT_NEAR(x.dot(d1), 0, 1e-15);
    EXPECT_NEAR(x.dot(d2) + d1.dot(d1), 0, 1e-14);
    EXPECT_NEAR(x.dot(d3) + 3 * d1.dot(d2), 0, 1e-13);
    EXPECT_LT((arc.jacobian(at).col(0) - d1).norm(), 1e-15);
  }
}

TEST(Nurbs, ClampsParametersIntoItsDomain) {
  const NurbsCurve arc = quarter_circle();
  EXPECT_EQ(arc.point(Parameter<1>(-3)), arc.point(Parameter<1>(0)));
  EXPECT_EQ(arc.point(Parameter<1>(7)), arc.point(Parameter<1>(1)));
}

TEST(Nurbs, PassesThroughItsCornerControlPoints) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const auto spline = test::random_nurbs<3>(random, 6, true);
    EXPECT_LT((spline.point(spline.low()) - spline.control_points().col(0)).norm(), 1e-15);
    EXPECT_LT((spline.point(spline.high()) - spline.control_points().rightCols<1>()).norm(), 1e-15);
  }
}

// A polynomial map times a polynomial weight, over that weight: every derivative is the polynomial's.
TEST(Nurbs, RationalDerivativesAreExactWhereTheWeightCancels) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> weight(0.5, 2);
  const auto random_polynomial = [&](std::array<int, 3> degree, bool positive) {
    BernsteinPolynomial p{degree,
                          Eigen::RowVectorXd::Random((degree[0] + 1) * (degree[1] + 1) * (degree[2] + 1))};
    if (positive)
      for (double& c : p.coefficients) c = weight(random);
    return p;
  };
  for (int trial = 0; trial < 5; ++trial) {
    const std::array<int, 3> degree = {2, 3, 2};
    const BernsteinPolynomial g = random_polynomial({1, 2, 1}, true);
    Eigen::Matrix3Xd plain(3, 3 * 4 * 3);
    Eigen::Matrix4Xd homogeneous(4, 4 * 6 * 4);
    for (int c = 0; c < 3; ++c) {
      const BernsteinPolynomial x = random_polynomial(degree, false);
      plain.row(c) = x.coefficients;
      homogeneous.row(c) = (x * g).coefficients;
    }
    const BernsteinPolynomial one{degree, Eigen::RowVectorXd::Ones(36)};
    homogeneous.row(3) = (one * g).coefficients;
    const NurbsVolume polynomial({KnotVector::bezier(2), KnotVector::bezier(3), KnotVector::bezier(2)},
                                 plain);
    const auto rational = NurbsVolume::from_homogeneous(
        {KnotVector::bezier(3), KnotVector::bezier(5), KnotVector::bezier(3)}, homogeneous);
    ASSERT_TRUE(rational.is_rational());
    const Parameter<3> at = test::random_parameter(random, polynomial);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d expected = polynomial.derivative(at, {i, j, k});
          EXPECT_LT((rational.derivative(at, {i, j, k}) - expected).norm(), 1e-10 * std::pow(4, i + j + k))
              << i << j << k;
        }
  }
}

TEST(Nurbs, MixedDerivativesMatchDifferencesOfLowerOnes) {
  std::mt19937 random(6);
  const double h = 1e-5;
  for (int trial = 0; trial < 10; ++trial) {
    const auto spline = test::random_nurbs<2>(random, 4, true);
    // Away from knots, where derivatives may jump.
    const auto breaks = spline.knots(0).breaks();
    Parameter<2> at = test::random_parameter(random, spline);
    at[0] = 0.4 * breaks[0] + 0.6 * breaks[1];
    const Parameter<2> step(h, 0);
    for (const std::array<int, 2> order :
         {std::array{0, 0}, std::array{0, 1}, std::array{1, 1}, std::array{1, 2}}) {
      const Eigen::Vector3d difference =
          (spline.derivative(at + step, order) - spline.derivative(at - step, order)) / (2 * h);
      const Eigen::Vector3d exact = spline.derivative(at, {order[0] + 1, order[1]});
      const double scale = 1 + spline.derivative(at, {order[0] + 3, order[1]}).norm();
      EXPECT_LT((difference - exact).norm(), 1e-8 * scale);
    }
  }
}

TEST(Nurbs, HomogeneousFormRoundTrips) {
  std::mt19937 random(7);
  const auto spline = test::random_nurbs<3>(random, 3, true);
  const auto again = NurbsVolume::from_homogeneous(spline.knots(), spline.homogeneous());
  EXPECT_LT((again.control_points() - spline.control_points()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
            1e-15);
  EXPECT_EQ(again.weights(), spline.weights());
}

}  // namespace
}  // namespace isopatch::geometry
