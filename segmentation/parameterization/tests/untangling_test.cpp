#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <random>

#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/internal/improve_blocks.hpp"
#include "segmentation/parameterization/internal/shape_energy.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/sample_solids.hpp"

namespace isopatch::segmentation {
namespace {

std::array<KnotVector, 3> cubic(int spans) {
  const auto knots = KnotVector::uniform(3, spans);
  return {knots, knots, knots};
}

Eigen::Matrix3Xd brick_net(const std::array<KnotVector, 3>& knots) {
  Eigen::Matrix3Xd net(3, Eigen::Index(knots[0].size()) * knots[1].size() * knots[2].size());
  Eigen::Index at = 0;
  for (const double z : knots[2].greville())
    for (const double y : knots[1].greville())
      for (const double x : knots[0].greville()) net.col(at++) = Eigen::Vector3d(x, 2 * y, 3 * z);
  return net;
}

TEST(ShapeEnergy, IsLeastForTheBrickItself) {
  const auto knots = cubic(2);
  const ShapeEnergy energy(knots, {1, 2, 3}, CountedPoints::all_but_corners);
  const ShapeEnergy::Value value = energy(brick_net(knots), 1e-9);
  EXPECT_NEAR(value.smallest, 1, 1e-12);
  EXPECT_LT(value.gradient.colwise().norm().maxCoeff<Eigen::PropagateNaN>(), 1e-9);
}

void expect_right_gradient(const Eigen::VectorXd& weights) {
  std::mt19937 random(7);
  const auto number = [&] { return 2.0 * random() / 4294967295.0 - 1; };
  const auto knots = cubic(2);
  const ShapeEnergy energy(knots, {1, 2, 3}, CountedPoints::inside_faces_and_interior, {{{0.3}, {}, {0.7}}},
                           weights);
  Eigen::Matrix3Xd net = brick_net(knots);
  for (auto& x : net.reshaped()) x += 0.5 * number();
  const double epsilon = 0.1;
  const ShapeEnergy::Value value = energy(net, epsilon);
  ASSERT_LT(value.smallest, 0);
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::Matrix3Xd direction = net;
    for (auto& x : direction.reshaped()) x = number();
    const double h = 1e-6;
    const double quotient =
        (energy(net + h * direction, epsilon).energy - energy(net - h * direction, epsilon).energy) / (2 * h);
    EXPECT_NEAR(quotient, value.gradient.cwiseProduct(direction).sum(),
                1e-5 * std::abs(quotient) + 1e-6 * value.energy);
  }
}

TEST(Untangling, FreesInnerPointsDisplacedAtRandom) {
  std::mt19937 random(3);
  const auto number = [&] { return 2.0 * random() / 4294967295.0 - 1; };
  const auto knots = cubic(2);
  Eigen::Matrix3Xd net = brick_net(knots);
  const Eigen::Matrix3Xd brick = net;
  const std::array<int, 3> n{5, 5, 5};
  std::vector<bool> outer(125, false);
  for (const Side side : geometry::all_sides)
    for (const int i : geometry::face_control_points(n, side)) outer[static_cast<std::size_t>(i)] = true;
  for (Eigen::Index i = 0; i < 125; ++i)
    if (!outer[static_cast<std::size_t>(i)])
      net.col(i) += Eigen::Vector3d(number(), 2 * number(), 3 * number());
  const geometry::NurbsVolume tangled(knots, net);
  ASSERT_FALSE(validity(tangled).certificate.accepted());
  const ImprovedPatch improved = improve_interior(tangled, 0.5, {});
  EXPECT_TRUE(improved.validity.certificate.accepted());
  EXPECT_GT(improved.validity.quality.min_scaled_jacobian, 0.5);
  for (Eigen::Index i = 0; i < 125; ++i) {
    if (!outer[static_cast<std::size_t>(i)]) continue;
    EXPECT_EQ(improved.patch.control_points().col(i), net.col(i));
  }
  EXPECT_GT(test::smallest_determinant(improved.patch, 9), 0);
}

TEST(ShapeEnergy, GradientIsTheDifferenceQuotientAlsoWhereItIsFolded) {
  expect_right_gradient({});
}

TEST(ShapeEnergy, GradientIsRightWithWeights) {
  std::mt19937 random(11);
  Eigen::VectorXd weights(125);
  for (double& weight : weights) weight = 0.5 + double(random()) / 4294967295.0;
  expect_right_gradient(weights);
}

// The map stays where all weights are the same; with others, the energy is that of the rational map.
TEST(ShapeEnergy, OfARationalBrickIsThatOfTheBrick) {
  const auto knots = cubic(2);
  const Eigen::Matrix3Xd net = brick_net(knots);
  const ShapeEnergy plain(knots, {1, 2, 3}, CountedPoints::all_but_corners);
  const ShapeEnergy doubled(knots, {1, 2, 3}, CountedPoints::all_but_corners, {},
                            Eigen::VectorXd::Constant(125, 2));
  EXPECT_NEAR(doubled(net, 1e-9).energy, plain(net, 1e-9).energy, 1e-12);
  Eigen::VectorXd uneven = Eigen::VectorXd::Ones(125);
  uneven[62] = 3;
  const ShapeEnergy::Value value =
      ShapeEnergy(knots, {1, 2, 3}, CountedPoints::all_but_corners, {}, uneven)(net, 1e-9);
  EXPECT_GT(value.energy, plain(net, 1e-9).energy + 1e-4);
}

/// Hexahedra of one amount of distortion.
struct Share {
  int before = 0, after = 0, folded_edges = 0, wrong = 0;
  double seconds = 0;
};

Share share(double amount, int count, int first_seed) {
  Share result;
  for (int i = 0; i < count; ++i) {
    const auto solid = test::random_hexahedron(static_cast<std::uint32_t>(first_seed + i), amount);
    const std::clock_t start = std::clock();
    const Parameterization made = parameterize(hex_model({solid}));
    result.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
    const PatchReport& patch = made.report.patches[0];
    result.before += patch.certified_before;
    result.after += patch.certificate.accepted();
    result.folded_edges += patch.folded_edge.has_value();
    const double smallest = test::smallest_determinant(made.patches.patches[0], 12);
    result.wrong += patch.certificate.accepted() && !(smallest > 0);
  }
  return result;
}

// Of the README's table: all are accepted that are distorted little, and of others most.
double least_share_accepted(double amount) {
  return amount < 0.15 ? 1 : amount < 0.25 ? 0.9 : 0;
}

// ISOPATCH_HEXAHEDRA=200 makes it the README's table: as many for each of five amounts.
TEST(Untangling, AcceptsMostRandomHexahedraAndNoneWrongly) {
  const char* asked = std::getenv("ISOPATCH_HEXAHEDRA");
  const int count = asked ? std::atoi(asked) : 4;
  for (const double amount : {0.1, 0.2, 0.3, 0.4, 0.5}) {
    const Share found = share(amount, count, static_cast<int>(1000 * amount));
    EXPECT_EQ(found.wrong, 0);
    EXPECT_GE(found.after, found.before);
    EXPECT_GE(found.after, least_share_accepted(amount) * count) << amount;
    if (asked)
      fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} s |\n", amount, count, found.before, found.after,
                 found.folded_edges, found.wrong, found.seconds / count);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace isopatch::segmentation
