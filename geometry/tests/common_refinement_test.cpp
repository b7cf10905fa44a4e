#include "geometry/common_refinement.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/base/larger.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using Eigen::Vector3d;

DividedSurface divided(const NurbsSurface& surface) {
  return {&surface, {surface.knots(0).breaks(), surface.knots(1).breaks()}};
}

NurbsSurface rectangle(const Vector3d& low, const Vector3d& high, const std::array<int, 2>& elements) {
  const NurbsVolume box = test::mapped(
      {KnotVector::uniform(1, elements[0]), KnotVector::uniform(1, elements[1]), KnotVector::bezier(1)},
      [&](const Vector3d& x) { return Vector3d(low + x.cwiseProduct(high - low)); });
  return face_surface(box, Side::front);
}

// The integral of a function of the place over all cells, with the largest distance of the two points.
template <class Function>
std::pair<double, double> integral(const std::vector<SharedCell>& cells, const NurbsSurface& first,
                                   const NurbsSurface& second, Function function) {
  double sum = 0, apart = 0;
  for (const SharedCell& cell : cells)
    for (const SharedPoint& point : cell.points) {
      const Vector3d place = first.point(point.first);
      apart = larger(apart, (place - second.point(point.second)).norm());
      sum += point.weight * function(place);
    }
  return {sum, apart};
}

// A narrow trapezoid that sticks out of a rectangle on both sides: parameters of the one are no guide far
// outside of the other.
TEST(CommonRefinement, KeepsToWhereATrapezoidCrossesARectangle) {
  const NurbsSurface wide = rectangle({40, 20, 10}, {80, 50, 10}, {1, 1});
  const NurbsVolume solid = test::mapped(
      {KnotVector::bezier(1), KnotVector::bezier(1), KnotVector::bezier(1)}, [](const Vector3d& x) {
        const double from = 15 - 5 * x[0], to = 55 + 5 * x[0];
        return Vector3d(47.5 + 2.5 * x[0], from + x[1] * (to - from), 10 + x[2]);
      });
  const NurbsSurface narrow = face_surface(solid, Side::front);
  for (const bool exchanged : {false, true}) {
    const SharedSurface shared = shared_surface(exchanged ? narrow : wide, exchanged ? wide : narrow, 1e-9);
    EXPECT_NEAR(shared.area, 2.5 * 30, 1e-9);
    EXPECT_LT(shared.gap, 1e-9);
  }
}

// 3 x 2 elements on 2 x 2 of a larger rectangle that is shifted by no multiple of theirs.
TEST(CommonRefinement, IsExactWhereLinesOfElementsAreParallel) {
  const NurbsSurface small = rectangle({0.3, 0.1, 0}, {1.5, 0.7, 0}, {3, 2});
  const NurbsSurface large = rectangle({0, 0, 0}, {2, 1, 0}, {2, 2});
  for (const bool exchanged : {false, true}) {
    const NurbsSurface& first = exchanged ? large : small;
    const NurbsSurface& second = exchanged ? small : large;
    const auto cells = common_refinement(divided(first), divided(second), 3, 1e-9);
    EXPECT_EQ(cells.size(), 12u);  // x: 0.3, 0.7, [1], 1.1, 1.5; y: 0.1, 0.4, [0.5], 0.7
    const auto [sum, apart] =
        integral(cells, first, second, [](const Vector3d& x) { return x[0] * x[0] * x[1]; });
    EXPECT_NEAR(sum, (std::pow(1.5, 3) - std::pow(0.3, 3)) / 3 * (0.49 - 0.01) / 2, 1e-14);
    EXPECT_LT(apart, 1e-14);
  }
}

TEST(CommonRefinement, KeepsToWhereTwoFacesOverlap) {
  const NurbsSurface left = rectangle({0, 0, 0}, {1, 1, 0}, {2, 2});
  const NurbsSurface right = rectangle({0.7, 0.2, 0}, {1.6, 1.5, 0}, {3, 3});
  const auto cells = common_refinement(divided(left), divided(right), 2, 1e-9);
  EXPECT_NEAR(integral(cells, left, right, [](const Vector3d&) { return 1.0; }).first, 0.3 * 0.8, 1e-14);
  EXPECT_NEAR(shared_surface(left, right, 1e-9).area, 0.3 * 0.8, 1e-14);
}

// Elements of a turned square are polygons on the other's.
TEST(CommonRefinement, IsExactWhereStraightLinesCross) {
  const NurbsSurface square = rectangle({-2, -2, 0}, {2, 2, 0}, {5, 4});
  const double turn = 0.4;
  const NurbsVolume turned = test::mapped(
      {KnotVector::uniform(1, 3), KnotVector::uniform(1, 2), KnotVector::bezier(1)}, [&](const Vector3d& x) {
        const Vector3d y = x - Vector3d(0.5, 0.5, 0);
        return Vector3d(std::cos(turn) * y[0] - std::sin(turn) * y[1],
                        std::sin(turn) * y[0] + std::cos(turn) * y[1], y[2]);
      });
  const NurbsSurface face = face_surface(turned, Side::front);
  const auto cells = common_refinement(divided(face), divided(square), 4, 1e-9);
  const auto [sum, apart] =
      integral(cells, face, square, [](const Vector3d& x) { return 1 + x[0] + x[0] * x[0]; });
  EXPECT_NEAR(sum, 1 + 1.0 / 12, 1e-13);  // a square's moment is the same about every axis
  EXPECT_LT(apart, 1e-13);
}

// Lines of elements that bend in each other's parameters, though both faces are plane: of an element that
// sticks out the part within counts, also where that part lies within one element.
TEST(CommonRefinement, CountsOfAnElementThatSticksOutThePartWithin) {
  const auto quadrilateral = [](double left_low, double left_high, double right_low, double right_high) {
    return face_surface(test::mapped({KnotVector::bezier(1), KnotVector::bezier(1), KnotVector::bezier(1)},
                                     [=](const Vector3d& x) {
                                       const double from = left_low + x[1] * (left_high - left_low);
                                       const double to = right_low + x[1] * (right_high - right_low);
                                       return Vector3d(from + x[0] * (to - from), x[1], x[2]);
                                     }),
                        Side::front);
  };
  const NurbsSurface first = quadrilateral(0, 0, 1.1, 0.9), second = quadrilateral(0.6, 0.8, 2, 2);
  const auto cells = common_refinement(divided(first), divided(second), 4, 1e-9);
  // Chords of 16 segments.
  EXPECT_NEAR(integral(cells, first, second, [](const Vector3d&) { return 1.0; }).first, 0.3, 1e-4);
}

// A fan of long elements and a rectangle that covers a part of it: neither lies within the other, elements
// end at the rectangle's border, and what is left of them is bent.
TEST(CommonRefinement, KeepsToWhereBentElementsCrossARectangle) {
  const double height = 0.8;
  const NurbsSurface fan = face_surface(test::ring_sector(1, 2, 0, 1.2, 1), Side::front);
  const NurbsSurface wide = rectangle({-1, 0, 0}, {3, height, 0}, {7, 1});
  const auto primitive = [&](double r) {
    return 0.5 * r * r * std::asin(height / r) + 0.5 * height * std::sqrt(r * r - height * height);
  };
  const double area = primitive(2) - primitive(1);
  std::vector<double> layers = {0, 0.125, 0.25, 0.5, 1};
  for (const bool exchanged : {false, true}) {
    const DividedSurface of_fan = {&fan, {layers, std::vector{0.0, 1.0}}};
    const auto cells = exchanged ? common_refinement(divided(wide), of_fan, 6, 1e-9)
                                 : common_refinement(of_fan, divided(wide), 6, 1e-9);
    const auto [sum, apart] =
        integral(cells, exchanged ? wide : fan, exchanged ? fan : wide, [](const Vector3d&) { return 1.0; });
    EXPECT_NEAR(sum, area, 1e-4 * area) << exchanged;
    EXPECT_LT(apart, 2e-4) << exchanged;  // chords of segments
  }
}

// Whatever their outline on the other surface is: here arcs, which chords would only be near to.
TEST(CommonRefinement, GivesElementsWithinOneOfTheOtherGaussPointsOfTheirOwn) {
  const NurbsSurface fan = face_surface(test::ring_sector(1, 2, 0, 1.2, 1), Side::front);
  const NurbsSurface wide = rectangle({-1, -1, 0}, {3, 3, 0}, {1, 1});
  const std::vector<double> halves = {0, 0.5, 1};
  const DividedSurface of_fan = {&fan, {halves, halves}};
  for (const bool exchanged : {false, true}) {
    const auto cells = exchanged ? common_refinement(divided(wide), of_fan, 8, 1e-9)
                                 : common_refinement(of_fan, divided(wide), 8, 1e-9);
    ASSERT_EQ(cells.size(), 4u);
    for (const SharedCell& cell : cells) EXPECT_EQ(cell.points.size(), 64u);
    const auto [sum, apart] =
        integral(cells, exchanged ? wide : fan, exchanged ? fan : wide, [](const Vector3d&) { return 1.0; });
    EXPECT_NEAR(sum, 1.2 * 1.5, 1e-10);  // Gauss's rule on rational functions
    EXPECT_LT(apart, 1e-12);
  }
}

// A quarter of a cylinder as one arc and as an arc of a third of it: other rational parameters.
TEST(CommonRefinement, FindsTheSamePointsOfArcsWithOtherParameters) {
  constexpr double quarter = std::numbers::pi / 2;
  const NurbsSurface whole = face_surface(test::ring_sector(1, 2, 0, quarter, 1), Side::east);
  const NurbsSurface third = face_surface(test::ring_sector(2, 3, 0, quarter / 3, 1), Side::west);
  const std::vector<double> ends = {0, 1};
  const auto cells = common_refinement({&whole, {std::vector{0.0, 0.25, 0.5, 1.0}, ends}},
                                       {&third, {std::vector{0.0, 0.5, 1.0}, ends}}, 8, 1e-9);
  const auto [sum, apart] = integral(cells, whole, third, [](const Vector3d&) { return 1.0; });
  EXPECT_NEAR(sum, 2 * quarter / 3, 1e-10);  // Gauss's rule on rational functions
  EXPECT_LT(apart, 1e-12);
}

}  // namespace
}  // namespace isopatch::geometry
