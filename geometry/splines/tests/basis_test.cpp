#include "geometry/splines/basis.hpp"

#include <gtest/gtest.h>

#include "geometry/splines/transfer.hpp"

namespace isopatch::geometry {
namespace {

TEST(Basis, DerivativesMatchFiniteDifferences) {
  const KnotVector knots(3, {0, 0, 0, 0, 0.3, 0.3, 0.7, 1, 1, 1, 1});
  const double h = 1e-6;
  for (const double t : {0.1, 0.45, 0.9}) {
    const auto exact = basis(knots, t, 2);
    const auto before = basis(knots, t - h, 1);
    const auto after = basis(knots, t + h, 1);
    ASSERT_EQ(before.first, after.first);
    EXPECT_NEAR(exact.values.row(0).sum(), 1, 1e-15);
    for (int d : {0, 1})
      EXPECT_LT(((after.values.row(d) - before.values.row(d)) / (2 * h) - exact.values.row(d + 1))
                    .cwiseAbs()
                    .maxCoeff<Eigen::PropagateNaN>(),
                1e-7);
  }
}

TEST(Transfer, RaisingAndInsertingKeepTheSpline) {
  const KnotVector coarse(2, {0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1});
  const KnotVector fine = with_knots(with_degree_raised(coarse, 3), {0.1, 0.1, 0.6, 0.25});
  const Eigen::VectorXd c = Eigen::VectorXd::Random(coarse.size());
  const Eigen::VectorXd f = transfer(coarse, fine) * c;
  for (double t = 0; t <= 1; t += 0.03125) {
    const auto a = basis(coarse, t);
    const auto b = basis(fine, t);
    EXPECT_NEAR(a.values.row(0).dot(c.segment(a.first, 3)), b.values.row(0).dot(f.segment(b.first, 6)),
                1e-14);
  }
}

}  // namespace
}  // namespace isopatch::geometry
