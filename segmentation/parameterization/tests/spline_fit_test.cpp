#include "segmentation/parameterization/internal/spline_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/base/larger.hpp"
#include "geometry/splines/nurbs.hpp"
#include "segmentation/parameterization/internal/coons.hpp"

namespace isopatch::segmentation {
namespace {

// The fit of a spline by splines: round-off of a least squares problem of some ten unknowns.
constexpr double exact_fit = 1e-11;

Eigen::Matrix3Xd random_net(Eigen::Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::Matrix3Xd::NullaryExpr(3, count, [&] { return uniform(random); });
}

KnotVector uneven() {
  return KnotVector(3, {0, 0, 0, 0, 0.2, 0.5, 0.5, 0.9, 2, 2, 2, 2});
}

TEST(SplineFit, ParametersLieInEverySpanAndAtTheEnds) {
  const std::vector<double> t = fitting_parameters(uneven(), 4);
  EXPECT_EQ(t.front(), 0);
  EXPECT_EQ(t.back(), 2);
  EXPECT_TRUE(std::is_sorted(t.begin(), t.end()));
  EXPECT_EQ(t.size(), 4u * 4 + 2);
  for (const auto& span : {std::pair(0.0, 0.2), {0.2, 0.5}, {0.5, 0.9}, {0.9, 2.0}})
    EXPECT_EQ(std::count_if(t.begin(), t.end(), [&](double x) { return x > span.first && x < span.second; }),
              4);
}

TEST(SplineFit, FindsASplineAgain) {
  const geometry::NurbsCurve curve({uneven()}, random_net(uneven().size(), 3));
  const std::vector<double> t = fitting_parameters(uneven(), 5);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(t.size()));
  for (std::size_t i = 0; i < t.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = curve.point(geometry::Parameter<1>(t[i]));
  const Eigen::Matrix3Xd net = fit_curve(uneven(), t, points, curve.control_points().leftCols<1>(),
                                         curve.control_points().rightCols<1>());
  EXPECT_LT((net - curve.control_points()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), exact_fit);
}

TEST(SplineFit, KeepsTheEndsThatItIsGiven) {
  const std::vector<double> t = fitting_parameters(uneven(), 3);
  const Eigen::Matrix3Xd points = random_net(static_cast<Eigen::Index>(t.size()), 5);
  const Eigen::Vector3d first(7, 8, 9), last(-7, 0, 1);
  const Eigen::Matrix3Xd net = fit_curve(uneven(), t, points, first, last);
  EXPECT_EQ(net.leftCols<1>(), first);
  EXPECT_EQ(net.rightCols<1>(), last);
}

// Fourth order for cubics: halving the spans divides the error by 16.
TEST(SplineFit, OfACircleConvergesWithItsOrder) {
  const auto error = [](int spans) {
    const KnotVector knots = KnotVector::uniform(3, spans);
    const auto circle = [](double t) {
      return Eigen::Vector3d(std::cos(std::numbers::pi * t), std::sin(std::numbers::pi * t), 0);
    };
    const std::vector<double> t = fitting_parameters(knots, 8);
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(t.size()));
    for (std::size_t i = 0; i < t.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = circle(t[i]);
    const geometry::NurbsCurve fitted({knots}, fit_curve(knots, t, points, circle(0), circle(1)));
    double worst = 0;
    for (int i = 0; i <= 200; ++i)
      worst = larger(worst, (fitted.point(geometry::Parameter<1>(i / 200.0)) - circle(i / 200.0)).norm());
    return worst;
  };
  double before = error(4);
  for (const int spans : {8, 16, 32}) {
    const double now = error(spans);
    EXPECT_NEAR(std::log2(before / now), 4, 0.3) << spans;
    before = now;
  }
}

TEST(SplineFit, FindsASurfaceAgainAndLeavesItsBoundary) {
  const std::array<KnotVector, 2> knots = {uneven(), KnotVector::uniform(2, 3)};
  const Eigen::Matrix3Xd net = random_net(Eigen::Index(knots[0].size()) * knots[1].size(), 8);
  const geometry::NurbsSurface surface(knots, net);
  const std::array<std::vector<double>, 2> t = {fitting_parameters(knots[0], 4),
                                                fitting_parameters(knots[1], 4)};
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(t[0].size() * t[1].size()));
  for (std::size_t j = 0; j < t[1].size(); ++j)
    for (std::size_t i = 0; i < t[0].size(); ++i)
      points.col(static_cast<Eigen::Index>(i + j * t[0].size())) = surface.point({t[0][i], t[1][j]});
  Eigen::Matrix3Xd start = net;
  const int n = knots[0].size(), m = knots[1].size();
  for (int j = 1; j + 1 < m; ++j)
    for (int i = 1; i + 1 < n; ++i) start.col(i + j * n).setZero();
  const Eigen::Matrix3Xd found = fit_surface(knots, t, points, start);
  EXPECT_LT((found - net).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 10 * exact_fit);
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
      if (i == 0 || j == 0 || i + 1 == n || j + 1 == m) {
        EXPECT_EQ(found.col(i + j * n), net.col(i + j * n));
      }
}

TEST(SplineFit, ErrorsOfLinesTellTheSpanWhereThePointsAreNoSpline) {
  const std::array<KnotVector, 2> knots = {KnotVector::uniform(2, 4), KnotVector::uniform(2, 2)};
  const std::array<std::vector<double>, 2> t = {fitting_parameters(knots[0], 6),
                                                fitting_parameters(knots[1], 6)};
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(t[0].size() * t[1].size()));
  for (std::size_t j = 0; j < t[1].size(); ++j)
    for (std::size_t i = 0; i < t[0].size(); ++i) {
      const double u = t[0][i];
      const bool rough = u > 0.5 && u < 0.75;  // the third span
      points.col(static_cast<Eigen::Index>(i + j * t[0].size())) << u, t[1][j],
          rough ? 0.1 * std::sin(8 * std::numbers::pi * u) : 0;
    }
  const std::vector<double> errors = line_errors(knots, t, points, 0);
  ASSERT_EQ(errors.size(), 4u);
  for (const std::size_t span : {0u, 1u, 3u}) EXPECT_GT(errors[2], 2 * errors[span]);
  EXPECT_GT(errors[2], 0.03);
  for (const double error : line_errors(knots, t, points, 1)) EXPECT_LT(error, exact_fit);
}

// Bilinear where the boundary is, whatever the knots: Greville points are linear.
TEST(CoonsNet, OfStraightBoundariesIsBilinear) {
  const std::array<KnotVector, 2> knots = {rescaled(uneven(), 0, 1), KnotVector::uniform(2, 3)};
  const auto bilinear = [](double s, double t) {
    return Eigen::Vector3d(s + 0.3 * s * t, t - 0.2 * s * t, 0.5 * s * t);
  };
  const std::vector<double> u = knots[0].greville(), v = knots[1].greville();
  Eigen::Matrix3Xd net(3, static_cast<Eigen::Index>(u.size() * v.size()));
  for (std::size_t j = 0; j < v.size(); ++j)
    for (std::size_t i = 0; i < u.size(); ++i)
      net.col(static_cast<Eigen::Index>(i + j * u.size())) = bilinear(u[i], v[j]);
  Eigen::Matrix3Xd hollow = net;
  for (std::size_t j = 1; j + 1 < v.size(); ++j)
    for (std::size_t i = 1; i + 1 < u.size(); ++i)
      hollow.col(static_cast<Eigen::Index>(i + j * u.size())).setConstant(std::nan(""));
  EXPECT_LT((coons_net(knots, hollow) - net).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-14);
}

TEST(CoonsNet, OfAVolumeIsTrilinearWhereItsBoundaryIs) {
  const std::array<KnotVector, 3> knots = {KnotVector::uniform(2, 3), KnotVector::uniform(3, 2),
                                           KnotVector::uniform(2, 2)};
  const auto trilinear = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return p + Eigen::Vector3d(0.3 * p[1] * p[2], -0.2 * p[0] * p[2], 0.4 * p[0] * p[1] * p[2]);
  };
  Eigen::Matrix3Xd net(3, Eigen::Index(knots[0].size()) * knots[1].size() * knots[2].size());
  Eigen::Matrix3Xd hollow = net;
  Eigen::Index at = 0;
  const auto u = knots[0].greville(), v = knots[1].greville(), w = knots[2].greville();
  const auto is_inner = [](std::size_t i, std::size_t n) { return i > 0 && i + 1 < n; };
  for (std::size_t k = 0; k < w.size(); ++k)
    for (std::size_t j = 0; j < v.size(); ++j)
      for (std::size_t i = 0; i < u.size(); ++i, ++at) {
        net.col(at) = trilinear({u[i], v[j], w[k]});
        hollow.col(at) = net.col(at);
        if (is_inner(i, u.size()) && is_inner(j, v.size()) && is_inner(k, w.size()))
          hollow.col(at).setConstant(std::nan(""));
      }
  EXPECT_LT((coons_net(knots, hollow) - net).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-14);
}

}  // namespace
}  // namespace isopatch::segmentation
