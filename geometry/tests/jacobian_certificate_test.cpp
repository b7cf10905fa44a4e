#include "geometry/jacobian_certificate.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/element_bounds.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using test::mapped;

// A box whose first direction is x = f(u), f' = (u - 0.3)^2 + c, so that det J has its minimum c on u = 0.3.
NurbsVolume squeezed(double c) {
  // Blossom of (u - 0.3)^3 / 3 + c u at (0,0,0), (0,0,1), (0,1,1), (1,1,1).
  const std::array<double, 4> x = {-0.027 / 3, 0.063 / 3 + c / 3, -0.147 / 3 + 2 * c / 3, 0.343 / 3 + c};
  const KnotVector cubic = KnotVector::bezier(3);
  return mapped({cubic, KnotVector(), KnotVector()}, [&](const Eigen::Vector3d& t) {
    return Eigen::Vector3d(x[static_cast<std::size_t>(std::lround(3 * t[0]))], t[1], t[2]);
  });
}

NurbsVolume random_volume(std::mt19937& random, bool rational, double distortion) {
  std::uniform_real_distribution<double> share(-1, 1);
  std::uniform_int_distribution<int> degree(1, 3);
  std::array<KnotVector, 3> knots;
  for (KnotVector& k : knots) k = KnotVector::bezier(degree(random));
  knots[0] = KnotVector::uniform(knots[0].degree(), 2);
  const NurbsVolume regular = mapped(knots, [](const Eigen::Vector3d& t) { return t; });
  Eigen::Matrix3Xd points = regular.control_points();
  Eigen::VectorXd weights = regular.weights();
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] += distortion * share(random);
  if (rational)
    for (double& w : weights) w += 0.5 * share(random);
  points.colwise() += Eigen::Vector3d(50, -20, 10);
  return NurbsVolume(knots, points, weights);
}

TEST(JacobianCertificate, IsExactForABox) {
  const JacobianCertificate c = certify_jacobian(test::box_between({1, 2, 3}, {3, 5, 3.5}));
  EXPECT_EQ(c.sign, JacobianSign::positive);
  EXPECT_NEAR(c.lower, 3, 1e-11);
  EXPECT_NEAR(c.upper, 3, 1e-11);
  EXPECT_LE(c.lower, 3);
  EXPECT_GE(c.upper, 3);
}

TEST(JacobianCertificate, EnclosesTheValuesOfRandomPatches) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share;
  int positive = 0;
  int negative = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const NurbsVolume patch = random_volume(random, trial % 2 == 0, trial % 3 == 0 ? 0.05 : 0.3);
    const JacobianCertificate c = certify_jacobian(patch);
    ASSERT_NE(c.sign, JacobianSign::undecided);
    for (int i = 0; i < 200; ++i) {
      const double determinant =
          patch.jacobian(Parameter<3>(share(random), share(random), share(random))).determinant();
      EXPECT_GE(determinant, c.lower);
      EXPECT_LE(determinant, c.upper);
    }
    EXPECT_GE(c.smallest, c.lower);
    EXPECT_NEAR(c.smallest, patch.jacobian(c.parameter).determinant(), 1e-12);
    EXPECT_LT((c.place - patch.point(c.parameter)).norm(), 1e-12);
    if (c.accepted()) {
      EXPECT_GT(c.lower, 0);
      ++positive;
    } else {
      EXPECT_LT(c.smallest, 0);
      ++negative;
    }
  }
  EXPECT_GT(positive, 15);
  EXPECT_GT(negative, 15);
}

TEST(JacobianCertificate, HasTheRightSizeForRationalPatches) {
  const double pi = std::numbers::pi;
  const NurbsVolume ring = test::ring_sector(1, 2, 0, 0.5 * pi, 0.5);
  const JacobianCertificate c = certify_jacobian(ring);
  EXPECT_EQ(c.sign, JacobianSign::positive);
  double lowest = 1e300;
  double highest = 0;
  for (int i = 0; i <= 100; ++i)
    for (const double u : {0.0, 1.0}) {
      const double d = ring.jacobian(Parameter<3>(u, i / 100.0, 0)).determinant();
      lowest = smaller(lowest, d);
      highest = larger(highest, d);
    }
  EXPECT_LE(c.lower, lowest);
  EXPECT_GE(c.upper, highest);
  // The weights are at least cos(22.5 degrees), 0.73 in the fourth power.
  EXPECT_GT(c.lower, 0.7 * lowest);
  EXPECT_LT(c.upper, highest / 0.7);
}

TEST(JacobianCertificate, DecidesMinimaNearZeroInsideAnElement) {
  const JacobianCertificate thin = certify_jacobian(squeezed(1e-6));
  EXPECT_EQ(thin.sign, JacobianSign::positive);
  EXPECT_GT(thin.lower, 0);
  EXPECT_LE(thin.lower, 1e-6);
  const JacobianCertificate folded = certify_jacobian(squeezed(-1e-6));
  EXPECT_EQ(folded.sign, JacobianSign::negative);
  EXPECT_LT(folded.smallest, 0);
  EXPECT_NEAR(folded.parameter[0], 0.3, 1e-3);
  EXPECT_EQ(certify_jacobian(squeezed(1e-6), {.max_depth = 0}).sign, JacobianSign::undecided);
}

TEST(JacobianCertificate, LeavesAZeroInsideUndecided) {
  const JacobianCertificate c = certify_jacobian(squeezed(0));
  EXPECT_FALSE(c.accepted());
  EXPECT_LT(c.lower, 1e-9);
}

TEST(JacobianCertificate, RejectsATinyFoldInACorner) {
  const NurbsVolume box = mapped({KnotVector::bezier(3), KnotVector::bezier(3), KnotVector::bezier(3)},
                                 [](const Eigen::Vector3d& t) { return t; });
  Eigen::Matrix3Xd points = box.control_points();
  points.col(1) = points.col(0) - Eigen::Vector3d(1e-8, 0, 0);
  const JacobianCertificate c = certify_jacobian(NurbsVolume(box.knots(), points));
  EXPECT_EQ(c.sign, JacobianSign::negative);
  EXPECT_EQ(c.parameter, Parameter<3>(0, 0, 0));
  EXPECT_NEAR(c.smallest, -3e-8, 1e-15);
  EXPECT_EQ(certify_jacobian(reversed(box, 1)).sign, JacobianSign::negative);
}

TEST(JacobianCertificate, AcceptsCollapsedEdgesAndFaces) {
  for (const bool rational : {false, true}) {
    // A ring whose inner face is its axis, and a tetrahedron-like box with an edge, a face and a point
    // collapsed.
    const NurbsVolume ring = test::ring_sector(1, 2, 0, 1.5, 0.5);
    Eigen::Matrix3Xd points = ring.control_points();
    for (Eigen::Index i = 0; i < points.cols(); i += 2) points.col(i).head<2>().setZero();
    const NurbsVolume wedge =
        rational ? NurbsVolume(ring.knots(), points, ring.weights()) : NurbsVolume(ring.knots(), points);
    EXPECT_EQ(certify_jacobian(wedge).sign, JacobianSign::nonnegative);
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(certify_jacobian(elevate_degree(wedge, d, 2)).sign, JacobianSign::nonnegative);
    EXPECT_EQ(certify_jacobian(reversed(wedge, 2)).sign, JacobianSign::negative);
    // Its top collapsed as well: a cone's tip, where det J has a double zero.
    for (Eigen::Index i = points.cols() / 2; i < points.cols(); ++i) points.col(i).head<2>().setZero();
    const NurbsVolume tip =
        rational ? NurbsVolume(ring.knots(), points, ring.weights()) : NurbsVolume(ring.knots(), points);
    EXPECT_EQ(certify_jacobian(tip).sign, JacobianSign::nonnegative);
  }
  const NurbsVolume box;
  Eigen::Matrix3Xd points = box.control_points();
  points.col(1) = points.col(0);  // one edge
  EXPECT_EQ(certify_jacobian(NurbsVolume(box.knots(), points)).sign, JacobianSign::nonnegative);
}

TEST(JacobianCertificate, DoesNotAcceptZerosElsewhere) {
  // A corner whose three edges lie in one plane: det J is zero there, and nothing is collapsed.
  const NurbsVolume box = mapped({KnotVector::bezier(2), KnotVector::bezier(2), KnotVector()},
                                 [](const Eigen::Vector3d& t) { return t; });
  Eigen::Matrix3Xd points = box.control_points();
  points.col(1) = Eigen::Vector3d(0.25, 0.25, 0);
  points.col(3) = Eigen::Vector3d(0.25, 0.25, 0);
  EXPECT_FALSE(certify_jacobian(NurbsVolume(box.knots(), points)).accepted());
}

TEST(JacobianCertificate, ScalesWithTheModelAndItsParameters) {
  std::mt19937 random(8);
  const NurbsVolume patch = random_volume(random, true, 0.05);
  const JacobianCertificate c = certify_jacobian(patch);
  const NurbsVolume large({rescaled(patch.knots(0), 0, 10), patch.knots(1), patch.knots(2)},
                          patch.control_points() * 1000, patch.weights() * 7);
  const JacobianCertificate scaled = certify_jacobian(large);
  EXPECT_NEAR(scaled.lower, c.lower * 1e8, 1e-9 * scaled.upper);
  EXPECT_NEAR(scaled.smallest, c.smallest * 1e8, 1e-9 * scaled.upper);
  EXPECT_ERROR(certify_jacobian(patch, {.max_depth = 31}), ErrorCode::invalid_argument, "max_depth is 31");
}

/// Bounds from expanding every element, one after the other.
Bounds plain_bounds(const NurbsVolume& volume) {
  const CentredVolume unit = centred(volume);
  Bounds result{1e300, -1e300};
  for (const NurbsVolume& element : bezier_pieces(unit.volume)) {
    const JacobianPiece piece = jacobian_piece(element, unit.radius);
    result.low = smaller(result.low, piece.lower());
    result.high = larger(result.high, piece.upper());
  }
  return result;
}

// Waves of the given height on a brick of n^3 elements, or on a quarter of a ring.
NurbsVolume wavy(int degree, int n, double height, bool rational) {
  const NurbsVolume ring = test::ring_sector(1, 2, 0, 1.5, 0.5);
  NurbsVolume fine = rational ? ring : test::box_between({0, 0, 0}, {1, 1, 1});
  for (int d = 0; d < 3; ++d) {
    fine = elevate_degree(fine, d, degree - fine.degree(d));
    std::vector<double> knots;
    for (int i = 1; i < n; ++i) knots.push_back((i - 0.1) * fine.knots(d).length() / n);
    if (n > 2) knots.push_back(knots[1]);  // one of them double
    fine = insert_knots(fine, d, knots);
  }
  Eigen::Matrix3Xd points = fine.control_points();
  for (auto&& point : points.colwise())
    point += height * Eigen::Vector3d(std::sin(5 * point[1]), std::cos(4 * point[2]), std::sin(6 * point[0]));
  return {fine.knots(), points, fine.weights()};
}

TEST(JacobianCertificate, IsThatOfAllElementsExpanded) {
  for (const bool rational : {false, true})
    for (const int degree : {2, 3})
      for (const double height : {0.0, 0.05}) {
        SCOPED_TRACE(testing::Message() << rational << degree << height);
        const NurbsVolume patch = wavy(degree, 5, height, rational);
        const JacobianCertificate found = certify_jacobian(patch);
        const Bounds plain = plain_bounds(patch);
        EXPECT_EQ(found.sign, JacobianSign::positive);
        // Elements whose bounds differ by less than 1e-9 are not told apart.
        EXPECT_NEAR(found.lower, plain.low, 2e-9 * plain.low);
        EXPECT_NEAR(found.upper, plain.high, 2e-9 * plain.high);
        EXPECT_NEAR(found.smallest, patch.jacobian(found.parameter).determinant(), 1e-14);
      }
}

TEST(JacobianCertificate, FindsAFoldInOneOfManyElements) {
  const NurbsVolume patch = wavy(2, 8, 0, false);
  Eigen::Matrix3Xd points = patch.control_points();
  points.col(points.cols() / 2)[0] += 0.4;
  const JacobianCertificate found = certify_jacobian({patch.knots(), points});
  EXPECT_EQ(found.sign, JacobianSign::negative);
  EXPECT_LT(found.smallest, 0);
}

TEST(ElementBounds, EncloseEveryBernsteinCoefficient) {
  for (const bool rational : {false, true}) {
    const CentredVolume unit = centred(wavy(3, 4, 0.02, rational));
    const std::vector<Bounds> wide = element_bounds(unit);
    const BezierElements elements(unit.volume);
    const std::vector<NurbsVolume> pieces = bezier_pieces(unit.volume);
    ASSERT_EQ(elements.count(), static_cast<int>(pieces.size()));
    ASSERT_EQ(wide.size(), pieces.size());
    for (std::size_t e = 0; e < pieces.size(); ++e) {
      const NurbsVolume element = elements[static_cast<int>(e)];
      EXPECT_LT((element.control_points() - pieces[e].control_points()).norm(), 1e-14);
      EXPECT_EQ(element.knots(), pieces[e].knots());
      const JacobianPiece piece = jacobian_piece(pieces[e], unit.radius);
      const double scale = piece.scale / std::pow(piece.lowest_weight, 4);
      const double lowest = piece.numerator.coefficients.minCoeff<Eigen::PropagateNaN>() * piece.scale /
                            std::pow(piece.highest_weight, 4);
      const double highest = piece.numerator.coefficients.maxCoeff<Eigen::PropagateNaN>() * scale;
      const Bounds sharp = element_bounds(pieces[e], unit.radius);
      for (const Bounds& bounds : {wide[e], sharp}) {
        EXPECT_LE(bounds.low, lowest);
        EXPECT_GE(bounds.high, highest);
      }
      // They are of use: half the value is left even of the wide ones.
      EXPECT_GT(sharp.low, 0.5 * lowest);
      EXPECT_GT(sharp.low, wide[e].low - 1e-3);
    }
  }
}

TEST(DeterminantBounds, EncloseRandomChoices) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    ColumnBoxes<4> boxes;
    boxes.centre = Eigen::Matrix4d::NullaryExpr([&] { return share(random); });
    boxes.half = 0.02 * Eigen::Matrix4d::NullaryExpr([&] { return std::abs(share(random)); });
    const Bounds bounds = determinant_bounds<4>(boxes);
    for (int choice = 0; choice < 50; ++choice) {
      const Eigen::Matrix4d chosen =
          boxes.centre + boxes.half.cwiseProduct(Eigen::Matrix4d::NullaryExpr([&] { return share(random); }));
      EXPECT_GE(chosen.determinant(), bounds.low);
      EXPECT_LE(chosen.determinant(), bounds.high);
    }
  }
  ColumnBoxes<3> exact;
  exact.centre << 2, 1, 0, 0, 3, 1, 0, 0, -4;
  exact.half.setZero();
  EXPECT_NEAR(determinant_bounds<3>(exact).low, -24, 1e-12);
  EXPECT_NEAR(determinant_bounds<3>(exact).high, -24, 1e-12);
}

}  // namespace
}  // namespace isopatch::geometry
