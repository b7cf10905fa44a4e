#include "iga/multigrid/smoothing_points.hpp"

#include <gtest/gtest.h>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/quadrature.hpp"
#include "iga/spaces/element_tables.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;

// Integrals of the products of all functions, or of their derivatives, by a number of Gauss points.
Eigen::MatrixXd products(const KnotVector& knots, int points, bool derivatives) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(knots.size(), knots.size());
  const int n = knots.degree() + 1;
  for (const DirectionTable::Element& e : direction_table(knots, geometry::gauss_legendre(points)).elements) {
    const Eigen::MatrixXd& values = derivatives ? e.derivatives : e.values;
    result.block(e.first, e.first, n, n) += values.transpose() * e.weights.asDiagonal() * values;
  }
  return result;
}

// The least share of its square integral that such points leave to any function.
double least_share(const KnotVector& knots, int points) {
  const int exact = knots.degree() + 1;
  return symmetric_eigen(products(knots, points, false), products(knots, exact, false)).values[0];
}

KnotVector line(int degree, int elements, int multiplicity) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int i = 1; i < elements; ++i) knots.insert(knots.end(), static_cast<std::size_t>(multiplicity), i);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, elements);
  return KnotVector(degree, knots);
}

TEST(SmoothingPoints, LeaveNearlyAllEnergyToAllFunctions) {
  for (int degree = 3; degree <= 5; ++degree)
    for (const int elements : {2, 3, 8}) {
      const KnotVector knots = line(degree, elements, 1);
      EXPECT_EQ(smoothing_points(knots), degree);
      EXPECT_GT(least_share(knots, degree), degree == 3 ? 0.83 : 0.94) << degree << " " << elements;
      // Products of derivatives are of degree 2 p - 2, which p points integrate.
      const Eigen::MatrixXd exact = products(knots, degree + 1, true);
      EXPECT_LT((products(knots, degree, true) - exact).norm(), 1e-13 * exact.norm());
    }
}

TEST(SmoothingPoints, AreOneMoreWhereFewerWouldLeaveSomeFunctionsLittle) {
  EXPECT_LT(least_share(line(3, 4, 2), 3), 0.6);
  EXPECT_LT(least_share(line(2, 2, 1), 2), 0.6);
  EXPECT_LT(least_share(line(4, 4, 4), 4), 1e-10);
  EXPECT_LT(least_share(line(3, 1, 1), 3), 1e-10);
  EXPECT_EQ(smoothing_points(line(3, 4, 2)), 4);
  EXPECT_EQ(smoothing_points(line(2, 2, 1)), 3);
  EXPECT_EQ(smoothing_points(line(4, 4, 4)), 5);
  EXPECT_EQ(smoothing_points(line(3, 1, 1)), 4);
  EXPECT_EQ(smoothing_points(line(4, 4, 2)), 4);
}

// Elements of 1:60 and of 1:300.
TEST(SmoothingPoints, AreOneMoreInSheets) {
  for (const double thickness : {1.0 / 60, 1.0 / 300}) {
    const ElasticityProblem p =
        testing::problem(geometry::connect(geometry::box_model({.size = {2, 2, 2 * thickness}})),
                         {.degree = {3, 3, 3}, .elements_per_direction = {2, 2, 2}}, testing::steel);
    const PatchSpace space = isoparametric_spaces(p.discretization).front();
    const int expected = thickness > 1.0 / 100 ? 3 : 4;
    EXPECT_EQ(smoothing_points(space), (GaussPoints{expected, expected, expected}));
  }
}

}  // namespace
}  // namespace isopatch::iga
