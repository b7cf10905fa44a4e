#include "geometry/measures.hpp"
#include "geometry/base/larger.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/multi_patch.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using test::box_between;
using test::ring_sector;

constexpr double pi = std::numbers::pi;

TEST(Measures, OfABoxAreItsEdges) {
  const NurbsVolume box = box_between({1, 2, 3}, {3, 5, 3.5});
  EXPECT_NEAR(volume(box), 3, 1e-14);
  EXPECT_NEAR(area(face_surface(box, Side::west)), 1.5, 1e-14);
  EXPECT_NEAR(area(face_surface(box, Side::north)), 1, 1e-14);
  EXPECT_NEAR(area(face_surface(box, Side::back)), 6, 1e-14);
  EXPECT_EQ(geometry::box(box).min(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(geometry::box(box).max(), Eigen::Vector3d(3, 5, 3.5));
  const Quality q = quality(box);
  EXPECT_NEAR(q.min_scaled_jacobian, 1, 1e-15);
  EXPECT_NEAR(q.mean_scaled_jacobian, 1, 1e-15);
  EXPECT_NEAR(q.min_jacobian, 3, 1e-14);
  EXPECT_EQ(connect({{box, box_between({3, 2, 3}, {4, 5, 3.5})}, {}, {}}).size(), std::sqrt(9 + 9 + 0.25));
}

TEST(Measures, OfACylinderAreItsClosedForms) {
  const NurbsVolume quarter = ring_sector(1, 2, 0, pi / 2, 0.5);
  EXPECT_NEAR(volume(quarter), pi / 4 * 3 * 0.5, 1e-14);
  EXPECT_NEAR(area(face_surface(quarter, Side::west)), pi / 2 * 0.5, 1e-14);
  EXPECT_NEAR(area(face_surface(quarter, Side::east)), pi * 0.5, 1e-14);
  EXPECT_NEAR(area(face_surface(quarter, Side::front)), pi / 4 * 3, 1e-14);
  EXPECT_NEAR(area(face_surface(quarter, Side::south)), 0.5, 1e-14);
  EXPECT_NEAR(volume(reversed(quarter, 1)), -volume(quarter), 1e-14);
}

TEST(Measures, VolumesOfPolynomialPatchesAreExactAtAnyDegree) {
  // The image of the unit cube under a map whose determinant, by Gauss's theorem, integrates to the box's
  // volume: inner control points may lie anywhere.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-0.2, 0.2);
  for (const int p : {2, 3, 4, 5, 6}) {
    const KnotVector knots = KnotVector::bezier(p);
    const NurbsVolume patch = test::mapped({knots, knots, knots}, [&](const Eigen::Vector3d& t) {
      const bool inside = (t.array() > 0.01).all() && (t.array() < 0.99).all();
      return Eigen::Vector3d(inside ? t + Eigen::Vector3d(share(random), share(random), share(random)) : t);
    });
    EXPECT_NEAR(volume(patch), 1, 1e-13) << p;
  }
}

TEST(Measures, MomentsOfASkewBlockAreThoseOfACubeMapped) {
  Eigen::Matrix3d map;
  map << 2, 0.5, -0.3, 0.1, 1, 0.4, -0.6, 0.2, 3;
  const Eigen::Vector3d low(0.7, -2, 4), origin(1, 1, 1);
  const NurbsVolume block =
      test::mapped({KnotVector::bezier(1), KnotVector::bezier(2), KnotVector::bezier(1)},
                   [&](const Eigen::Vector3d& t) { return Eigen::Vector3d(low + map * t); });
  const double expected = map.determinant();
  const Eigen::Vector3d middle = low + map * Eigen::Vector3d::Constant(0.5) - origin;
  const VolumeMoments found = volume_moments(block, origin);
  // Round-off of sums of numbers up to 100.
  EXPECT_NEAR(found.volume, expected, 1e-12);
  EXPECT_LT((found.first - expected * middle).norm(), 1e-12);
  const Eigen::Matrix3d second = expected * (map * map.transpose() / 12 + middle * middle.transpose());
  EXPECT_LT((found.second - second).norm(), 1e-12);
  // A left-handed patch counts negative, as its volume does.
  const VolumeMoments turned = volume_moments(reversed(block, 1), origin);
  EXPECT_NEAR(turned.volume, -expected, 1e-12);
  EXPECT_LT((turned.second + second).norm(), 1e-12);
}

TEST(Measures, MomentsOfARingSectorAreItsClosedForms) {
  const VolumeMoments found = volume_moments(ring_sector(1, 2, 0, pi / 2, 0.5), Eigen::Vector3d(0, 0, 0.5));
  EXPECT_NEAR(found.first.x(), 7. / 3 * 0.5, 1e-14);
  EXPECT_NEAR(found.first.z(), -0.25 * pi / 4 * 3 * 0.5, 1e-14);
  EXPECT_NEAR(found.second(0, 0), 15. / 4 * pi / 4 * 0.5, 1e-14);
  EXPECT_NEAR(found.second(0, 1), 15. / 8 * 0.5, 1e-14);
  EXPECT_NEAR(found.second(1, 2), -0.25 * 7. / 3 * 0.5, 1e-14);
  EXPECT_LT((found.second - found.second.transpose()).norm(), 1e-14);
}

TEST(Measures, NormalsPointOutOfRightHandedPatches) {
  const NurbsVolume ring = ring_sector(1, 2, 0, pi / 2, 0.5);
  const Parameter<2> at(0.3, 0.6);
  for (const Side side : all_sides) {
    const Eigen::Vector3d point = ring.point(on_side(ring, side, at));
    const Eigen::Vector3d radial = Eigen::Vector3d(point[0], point[1], 0).normalized();
    const Eigen::Vector3d around(-radial[1], radial[0], 0);
    const std::array<Eigen::Vector3d, 6> expected = {
        -radial, radial, -around, around, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()};
    EXPECT_LT((outward_normal(ring, side, at) - expected[static_cast<std::size_t>(side)]).norm(), 1e-14)
        << name(side);
  }
}

/// A rational patch, and a B-spline that is as curved.
std::vector<NurbsVolume> curved_patches() {
  const NurbsVolume ring = elevate_degree(insert_knots(ring_sector(1, 2, 0.1, 2, 3), 0, {0.2, 0.7}), 2, 1);
  return {ring, NurbsVolume(ring.knots(), ring.control_points())};
}

void expect_plain_sums(const NurbsVolume& patch) {
  const QuadratureRule rule = gauss_legendre(12);
  double sum = 0;
  double smallest = 1e300, scaled = 0, worst = 1;
  int count = 0;
  for (const NurbsVolume& piece : bezier_pieces(patch))
    for (Eigen::Index i = 0; i < 12 * 12 * 12; ++i) {
      const Eigen::Vector3i k(static_cast<int>(i % 12), static_cast<int>(i / 12 % 12),
                              static_cast<int>(i / 144));
      const Parameter<3> share(rule.nodes[k[0]], rule.nodes[k[1]], rule.nodes[k[2]]);
      const Parameter<3> length = piece.high() - piece.low();
      const Eigen::Matrix3d columns = patch.jacobian(piece.low() + share.cwiseProduct(length));
      const double determinant = columns.determinant();
      worst = smaller(worst, determinant / columns.colwise().norm().prod());
      scaled += determinant / columns.colwise().norm().prod();
      ++count;
      sum += rule.weights[k[0]] * rule.weights[k[1]] * rule.weights[k[2]] * length.prod() * determinant;
      smallest = smaller(smallest, determinant);
    }
  EXPECT_NEAR(volume(patch), sum, 1e-13 * sum);
  const Quality q = quality(patch, 12);
  EXPECT_NEAR(q.min_jacobian, smallest, 1e-13);
  EXPECT_NEAR(q.min_scaled_jacobian, worst, 1e-13);
  EXPECT_NEAR(q.mean_scaled_jacobian, scaled / count, 1e-13);
}

TEST(Measures, EqualAPlainSumOverTheGaussPoints) {
  for (const NurbsVolume& patch : curved_patches()) expect_plain_sums(patch);
}

TEST(Measures, QualityFindsTheWorstPoint) {
  // A box with one corner pushed in: the worst Gauss point is the one nearest to that corner.
  Eigen::Matrix3Xd points = box_between({0, 0, 0}, {1, 1, 1}).control_points();
  points.col(7) = Eigen::Vector3d(0.45, 0.45, 0.45);
  const NurbsVolume patch({}, points);
  const Quality q = quality(patch, 3);
  const double last = 0.5 + std::sqrt(0.15);
  EXPECT_LT((q.worst_parameter - Parameter<3>(last, last, last)).norm(), 1e-14);
  EXPECT_NEAR(q.min_jacobian, patch.jacobian(q.worst_parameter).determinant(), 1e-15);
  EXPECT_LT(q.min_scaled_jacobian, 0.8);
  EXPECT_GT(q.mean_scaled_jacobian, q.min_scaled_jacobian);
  EXPECT_LT(quality(reversed(patch, 0)).min_scaled_jacobian, 0);
}

}  // namespace
}  // namespace isopatch::geometry
