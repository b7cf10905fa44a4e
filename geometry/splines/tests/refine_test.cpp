#include "geometry/splines/refine.hpp"

#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/permute.hpp"
#include "geometry/splines/tests/random_nurbs.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::geometry {
namespace {

using test::de_casteljau;
using test::random_nurbs;
using test::random_parameter;

/// Points are of size 1 with weights in 0.5 .. 2; all operations are averages, so some tens of units in the
/// last place.
constexpr double round_off = 2e-14;

template <int D>
double largest_difference(std::mt19937& random, const Nurbs<D>& a, const Nurbs<D>& b) {
  double largest = 0;
  for (int i = 0; i < 20; ++i) {
    const Parameter<D> at = random_parameter(random, a);
    largest = larger(largest, (a.point(at) - b.point(at)).norm());
  }
  return largest;
}

template <int D>
double control_point_difference(const Nurbs<D>& a, const Nurbs<D>& b) {
  EXPECT_EQ(a.knots(), b.knots());
  return (a.homogeneous() - b.homogeneous()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
}

// New knots: some inside elements, some on breaks that have room.
std::vector<double> random_new_knots(std::mt19937& random, const KnotVector& knots) {
  std::vector<double> result;
  std::uniform_real_distribution<double> share(0.1, 0.9);
  const auto breaks = knots.breaks();
  const auto multiplicities = knots.multiplicities();
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) {
    result.push_back(breaks[e] + share(random) * (breaks[e + 1] - breaks[e]));
    if (knots.degree() > 1) result.push_back(result.back());
    if (e > 0 && multiplicities[e] < knots.degree()) result.push_back(breaks[e]);
  }
  return result;
}

template <class Dimension>
class Refine : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Refine, Dimensions);

TYPED_TEST(Refine, InsertionAndElevationKeepTheMapAndCommute) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(10 + D);
  for (int trial = 0; trial < 30 / D; ++trial) {
    const auto spline = random_nurbs<D>(random, D == 3 ? 4 : 6, trial % 2 == 0);
    const int d = trial % D;
    const auto knots = random_new_knots(random, spline.knots(d));
    const auto inserted = insert_knots(spline, d, knots);
    const auto elevated = elevate_degree(spline, d, 2);
    EXPECT_LT(largest_difference(random, spline, inserted), round_off);
    EXPECT_LT(largest_difference(random, spline, elevated), round_off);
    // Elevation raises the multiplicity of every knot, the new ones included, so they are inserted three
    // times.
    std::vector<double> repeated;
    for (const double t : knots) {
      const auto breaks = spline.knots(d).breaks();
      const bool new_break = std::find(breaks.begin(), breaks.end(), t) == breaks.end();
      repeated.push_back(t);
      if (new_break && (repeated.size() < 2 || repeated[repeated.size() - 2] != t))
        repeated.insert(repeated.end(), 2, t);
    }
    EXPECT_LT(control_point_difference(elevate_degree(inserted, d, 2), insert_knots(elevated, d, repeated)),
              round_off);
    EXPECT_EQ(inserted.is_rational(), spline.is_rational());
    EXPECT_EQ(elevated.is_rational(), spline.is_rational());
  }
}

TYPED_TEST(Refine, StepsAddUp) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(20 + D);
  for (int trial = 0; trial < 10; ++trial) {
    const auto spline = random_nurbs<D>(random, 4, true);
    const auto twice = elevate_degree(elevate_degree(spline, 0, 1), 0, 2);
    EXPECT_LT(control_point_difference(twice, elevate_degree(spline, 0, 3)), round_off);
    const auto knots = random_new_knots(random, spline.knots(0));
    auto one_by_one = spline;
    for (const double t : knots) one_by_one = insert_knots(one_by_one, 0, {t});
    EXPECT_LT(control_point_difference(one_by_one, insert_knots(spline, 0, knots)), round_off);
  }
}

TYPED_TEST(Refine, BezierPiecesAgreeWithDeCasteljau) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(30 + D);
  for (int trial = 0; trial < 30 / D; ++trial) {
    const auto spline = random_nurbs<D>(random, D == 3 ? 4 : 6, trial % 2 == 0);
    const auto pieces = bezier_pieces(spline);
    std::size_t expected = 1;
    for (const KnotVector& k : spline.knots()) expected *= static_cast<std::size_t>(k.element_count());
    ASSERT_EQ(pieces.size(), expected);
    double measure = 0;
    for (const auto& piece : pieces) {
      measure += (piece.high() - piece.low()).prod();
      const Parameter<D> at = random_parameter(random, piece);
      EXPECT_LT((spline.point(at) - de_casteljau(piece, at)).norm(), round_off);
      EXPECT_LT((spline.jacobian(at) - piece.jacobian(at)).norm(), 1e3 * round_off);
    }
    EXPECT_NEAR(measure, (spline.high() - spline.low()).prod(), 1e-12 * measure);
  }
}

TYPED_TEST(Refine, ReversalTurnsTheParameterAround) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(40 + D);
  for (int trial = 0; trial < 10; ++trial) {
    const auto spline = random_nurbs<D>(random, 4, true);
    for (int d = 0; d < D; ++d) {
      const auto turned = reversed(spline, d);
      Parameter<D> at = random_parameter(random, spline);
      const Eigen::Vector3d point = spline.point(at);
      const auto jacobian = spline.jacobian(at);
      at[d] = spline.knots(d).first() + (spline.knots(d).last() - at[d]);
      EXPECT_LT((turned.point(at) - point).norm(), round_off);
      EXPECT_LT((turned.jacobian(at).col(d) + jacobian.col(d)).norm(), 1e-11);
      EXPECT_EQ(reversed(turned, d).control_points(), spline.control_points());
      EXPECT_EQ(reversed(turned, d).weights(), spline.weights());
    }
  }
}

TYPED_TEST(Refine, GridsOfPointsEqualSinglePoints) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(50 + D);
  const auto spline = random_nurbs<D>(random, 4, true);
  GridParameters<D> grid;
  std::array<std::size_t, 3> counts = {1, 1, 1};
  for (std::size_t d = 0; d < D; ++d) {
    const KnotVector& k = spline.knots()[d];
    for (std::size_t i = 0; i < 3 + d; ++i)
      grid[d].push_back(random_parameter(random, spline)[static_cast<int>(d)]);
    grid[d].push_back(k.last());
    counts[d] = grid[d].size();
  }
  const Eigen::Matrix3Xd points = points_on_grid(spline, grid);
  ASSERT_EQ(points.cols(), static_cast<Eigen::Index>(counts[0] * counts[1] * counts[2]));
  for (std::size_t i = 0; i < counts[0] * counts[1] * counts[2]; ++i) {
    Parameter<D> at;
    std::size_t rest = i;
    for (std::size_t d = 0; d < D; ++d) {
      at[static_cast<int>(d)] = grid[d][rest % counts[d]];
      rest /= counts[d];
    }
    EXPECT_LT((points.col(static_cast<Eigen::Index>(i)) - spline.point(at)).norm(), round_off);
  }
}

TEST(Refinement, RefusesSpacesThatDoNotContainTheCoarseOne) {
  const NurbsCurve line;
  EXPECT_ERROR(insert_knots(line, 0, {0.0}), ErrorCode::invalid_argument, "cannot insert knot 0");
  EXPECT_ERROR(insert_knots(line, 0, {1.5}), ErrorCode::invalid_argument, "cannot insert knot 1.5");
  EXPECT_ERROR(insert_knots(line, 0, {std::nan("")}), ErrorCode::invalid_argument, "cannot insert knot nan");
  EXPECT_ERROR(insert_knots(line, 0, {0.5, 0.5}), ErrorCode::invalid_argument, "more than degree = 1 times");
  EXPECT_ERROR(elevate_degree(line, 0, -1), ErrorCode::invalid_argument, "cannot raise the degree -1 times");
  EXPECT_ERROR(elevate_degree(line, 0, 20), ErrorCode::invalid_argument, "outside 1 ..");
  EXPECT_ERROR(refined(elevate_degree(line, 0, 1), {KnotVector()}), ErrorCode::invalid_argument,
               "fine degree 1 is below");
  EXPECT_ERROR(refined(insert_knots(line, 0, {0.5}), {KnotVector::bezier(2)}), ErrorCode::invalid_argument,
               "do not contain the coarse ones");
  EXPECT_ERROR(refined(line, {KnotVector::bezier(1, 0, 2)}), ErrorCode::invalid_argument,
               "do not contain the coarse ones");
}

TEST(Refinement, IsStableAtHighDegree) {
  std::mt19937 random(60);
  KnotVector coarse = KnotVector::uniform(2, 12);
  for (const int degree : {5, 10, 20}) {
    const KnotVector fine = with_degree_raised(coarse, degree - 2);
    const Eigen::MatrixXd matrix = transfer(coarse, fine);
    // The rows of a B-spline transfer are averages; anything else is cancellation.
    EXPECT_LT((matrix.rowwise().sum().array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), 1e-13) << degree;
    EXPECT_GT(matrix.minCoeff<Eigen::PropagateNaN>(), -1e-14) << degree;
  }
  // Bezier extraction of a smooth spline of degree 20: also averages.
  const KnotVector smooth = KnotVector::uniform(20, 8);
  const Eigen::MatrixXd matrix = transfer(smooth, bezier_knots(smooth));
  EXPECT_LT((matrix.rowwise().sum().array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), 1e-13);
  EXPECT_GT(matrix.minCoeff<Eigen::PropagateNaN>(), -1e-14);
}

TEST(Transfer, ToASpaceThatDoesNotHoldTheOtherIsRefused) {
  EXPECT_ERROR(transfer(KnotVector::uniform(3, 2), KnotVector::uniform(2, 4)), ErrorCode::invalid_argument,
               "the fine degree 2 is below the coarse degree 3");
  EXPECT_ERROR(transfer(KnotVector::uniform(2, 4), KnotVector::uniform(2, 3)), ErrorCode::invalid_argument,
               "knot");
}

TEST(Permuted, DirectionsThatAppearTwiceAreRefused) {
  std::mt19937 random(3);
  EXPECT_ERROR(permuted(random_nurbs<3>(random, 2, true), {0, 1, 1}), ErrorCode::invalid_argument,
               "every direction must appear exactly once");
}

}  // namespace
}  // namespace isopatch::geometry
