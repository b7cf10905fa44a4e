#include "geometry/shared_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/larger.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using Eigen::Vector3d;

constexpr double near = 1e-9;

DividedSurface in_elements(const NurbsSurface& surface) {
  return {&surface, {surface.knots(0).breaks(), surface.knots(1).breaks()}};
}

std::optional<SharedGrid> grid_of(const NurbsSurface& first, const NurbsSurface& second, int points) {
  return shared_grid(in_elements(first), in_elements(second), {points, points}, near);
}

// A rectangle of a plane, its directions exchanged if asked for.
NurbsSurface plane(const Vector3d& low, const Vector3d& high, const std::array<int, 2>& elements,
                   bool swapped = false) {
  return face_surface(test::mapped({KnotVector::uniform(1, elements[0]), KnotVector::uniform(1, elements[1]),
                                    KnotVector::bezier(1)},
                                   [&](const Vector3d& x) {
                                     const Vector3d y = swapped ? Vector3d(x[1], x[0], x[2]) : x;
                                     return Vector3d(low + y.cwiseProduct(high - low));
                                   }),
                      Side::front);
}

// The integral of a function of the place, and how far the points of the two faces are apart at most.
template <class Function>
std::pair<double, double> integral(const SharedGrid& grid, const NurbsSurface& first,
                                   const NurbsSurface& second, Function function) {
  double sum = 0, apart = 0;
  const auto& [u, v] = grid.lines;
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const Parameter<2> at(u.first[i], v.first[j]);
      Parameter<2> there;
      there[grid.second_direction(0)] = u.second[i];
      there[grid.second_direction(1)] = v.second[j];
      const auto tangents = first.jacobian(at);
      const double area = Vector3d(tangents.col(0)).cross(Vector3d(tangents.col(1))).norm();
      const Vector3d place = first.point(at);
      apart = larger(apart, (place - second.point(there)).norm());
      sum += u.weights[i] * v.weights[j] * area * function(place);
    }
  return {sum, apart};
}

TEST(SharedGrid, HasTheCellsOfBothFacesWhereTheyOverlap) {
  const NurbsSurface small = plane({0.3, 0.1, 0}, {1.5, 0.7, 0}, {3, 2});
  for (const bool swapped : {false, true}) {
    const NurbsSurface large = plane({0, 0, 0}, {2, 1, 0}, {2, 2}, swapped);
    const auto grid = grid_of(small, large, 3);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->swapped, swapped);
    EXPECT_EQ(grid->lines[0].size(), 3u * 4u);  // x: 0.3, 0.7, [1], 1.1, 1.5
    EXPECT_EQ(grid->lines[1].size(), 3u * 3u);  // y: 0.1, 0.4, [0.5], 0.7
    EXPECT_EQ(grid->lines[0].first_element, (std::vector{0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2}));
    EXPECT_EQ(grid->lines[0].second_element, (std::vector{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}));
    const auto [sum, apart] =
        integral(*grid, small, large, [](const Vector3d& x) { return x[0] * x[0] * x[1]; });
    EXPECT_NEAR(sum, (std::pow(1.5, 3) - std::pow(0.3, 3)) / 3 * (0.49 - 0.01) / 2, 1e-14);
    EXPECT_LT(apart, 1e-14);
  }
}

TEST(SharedGrid, KeepsToWhereNeitherFaceLiesWithinTheOther) {
  const NurbsSurface left = plane({0, 0, 0}, {1, 1, 0}, {2, 2});
  const NurbsSurface right = plane({0.7, 0.2, 0}, {1.6, 1.5, 0}, {3, 3});
  const auto grid = grid_of(left, right, 2);
  ASSERT_TRUE(grid);
  EXPECT_NEAR(integral(*grid, left, right, [](const Vector3d&) { return 1.0; }).first, 0.3 * 0.8, 1e-14);
}

// A cylinder's arc and a third of it: parameters that are no multiples of each other.
TEST(SharedGrid, FindsPlacesOnArcsOfOtherRationalParameters) {
  const NurbsSurface whole = face_surface(test::ring_sector(1, 2, 0, 1.5, 1), Side::east);
  const NurbsSurface third = face_surface(test::ring_sector(2, 3, 0, 0.5, 1), Side::west);
  const auto grid = grid_of(whole, third, 12);
  ASSERT_TRUE(grid);
  const auto [sum, apart] = integral(*grid, whole, third, [](const Vector3d&) { return 1.0; });
  EXPECT_NEAR(sum, 2 * 0.5, 1e-12);
  EXPECT_LT(apart, 1e-12);
}

TEST(SharedGrid, IsNothingWhereLinesCrossOrBend) {
  const NurbsSurface square = plane({-2, -2, 0}, {2, 2, 0}, {5, 4});
  const auto turned = [](double turn, double bend) {
    return face_surface(
        test::mapped({KnotVector::uniform(2, 3), KnotVector::uniform(2, 2), KnotVector::bezier(1)},
                     [=](const Vector3d& x) {
                       const Vector3d y = x - Vector3d(0.5, 0.5, 0);
                       return Vector3d(std::cos(turn) * y[0] - std::sin(turn) * y[1] + bend * y[0] * y[1],
                                       std::sin(turn) * y[0] + std::cos(turn) * y[1], y[2]);
                     }),
        Side::front);
  };
  EXPECT_TRUE(grid_of(turned(0, 0), square, 3));
  EXPECT_FALSE(grid_of(turned(0.4, 0), square, 3));
  EXPECT_FALSE(grid_of(turned(0, 0.3), square, 3));
  EXPECT_FALSE(grid_of(plane({0, 0, 1}, {1, 1, 1}, {2, 2}), square, 3));  // apart
}

}  // namespace
}  // namespace isopatch::geometry
