#include "segmentation/parameterization/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/parameterization/outline.hpp"

namespace isopatch::segmentation {
namespace {

using Outline = std::vector<Eigen::Vector2d>;

double polygon_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

// Triangles turn left, cover the polygon and meet edge to edge; the outline's edges are in one of them each.
void expect_covers(const Outline& outline, const Triangulation& mesh) {
  double sum = 0;
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles) {
    const double twice =
        doubled_area(mesh.points[static_cast<std::size_t>(t[0])], mesh.points[static_cast<std::size_t>(t[1])],
                     mesh.points[static_cast<std::size_t>(t[2])]);
    EXPECT_GE(twice, -1e-14);
    sum += twice / 2;
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  EXPECT_NEAR(sum, polygon_area(outline), 1e-12);
  EXPECT_EQ(mesh.outline, static_cast<int>(outline.size()));
  int rim = 0;
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1) << "an edge twice in one sense";
    if (uses.contains({edge.second, edge.first})) continue;
    EXPECT_EQ((edge.first + 1) % mesh.outline, edge.second) << "only the outline has nothing beyond it";
    ++rim;
  }
  EXPECT_EQ(rim, mesh.outline);
}

const Outline square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Outline l_shaped = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

Outline star() {
  Outline result;
  for (int i = 0; i < 14; ++i) {
    const double angle = std::numbers::pi * i / 7, radius = i % 2 == 0 ? 1 : 0.35;
    result.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return result;
}

TEST(Triangulation, CoversPolygonsWithCornersInwards) {
  for (const Outline& outline : {square, l_shaped, star()})
    for (const int inner : {0, 1, 40}) expect_covers(outline, triangulate(outline, inner));
}

TEST(Triangulation, TakesCornersInStraightLines) {
  const Outline outline = {{0, 0}, {0.5, 0}, {1, 0}, {1, 0.3}, {1, 1}, {0, 1}, {0, 0.5}};
  expect_covers(outline, triangulate(outline, 10));
}

TEST(Triangulation, HasAboutAsManyInnerPointsAsAskedFor) {
  const Triangulation mesh = triangulate(square, 100);
  const auto inner = static_cast<int>(mesh.points.size()) - mesh.outline;
  EXPECT_GT(inner, 50);
  EXPECT_LT(inner, 200);
}

TEST(Triangulation, DividesInnerEdgesAtTheirMiddles) {
  Triangulation mesh = triangulate(square, 1);
  ASSERT_EQ(mesh.points.size(), 5u) << "one inner point, joined to all four corners";
  ASSERT_EQ(mesh.triangles.size(), 4u);
  divide_edges(mesh, [](int a, int b) { return a < 5 && b < 5; });
  ASSERT_EQ(mesh.points.size(), 9u) << "edges of the outline are left alone";
  EXPECT_EQ(mesh.triangles.size(), 12u);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2d middle = (mesh.points[corner] + mesh.points[4]) / 2;
    EXPECT_EQ(std::count(mesh.points.begin() + 5, mesh.points.end(), middle), 1) << corner;
  }
  expect_covers(square, mesh);
  divide_edges(mesh, [](int, int) { return false; });
  EXPECT_EQ(mesh.points.size(), 9u);
}

TEST(Triangulation, RefusesAnOutlineThatRunsTheOtherWay) {
  const Outline clockwise(square.rbegin(), square.rend());
  EXPECT_ERROR(triangulate(clockwise, 0), ErrorCode::internal, "cannot be triangulated");
}

std::vector<DomainCurve> loop_of(const Outline& corners) {
  std::vector<DomainCurve> result;
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.push_back([a = corners[i], b = corners[(i + 1) % corners.size()]](double t) -> Eigen::Vector2d {
      return (1 - t) * a + t * b;
    });
  return result;
}

TEST(Outline, CrossesItselfWhereItDoes) {
  EXPECT_FALSE(self_intersection(loop_of(square)));
  EXPECT_FALSE(self_intersection(loop_of(star())));
  const auto crossing = self_intersection(loop_of({{0, 0}, {1, 0.9}, {1, 0}, {0, 1}}));
  ASSERT_TRUE(crossing);
  EXPECT_LT((*crossing - Eigen::Vector2d(1, 0.9) / 1.9).norm(), 1e-9);
}

TEST(Outline, BlendOfFourCurvesKeepsThem) {
  const std::array<DomainCurve, 4> sides = {[](double t) -> Eigen::Vector2d {
                                              return {t, 0.2 * std::sin(std::numbers::pi * t)};
                                            },
                                            [](double t) -> Eigen::Vector2d {
                                              return {t, 1 + 0.1 * t * (1 - t)};
                                            },
                                            [](double t) -> Eigen::Vector2d {
                                              return {-0.3 * t * (1 - t), t};
                                            },
                                            [](double t) -> Eigen::Vector2d {
                                              return {1, t};
                                            }};
  for (const double t : {0.0, 0.3, 0.8, 1.0}) {
    EXPECT_LT((coons_point(sides, t, 0) - sides[0](t)).norm(), 1e-15);
    EXPECT_LT((coons_point(sides, t, 1) - sides[1](t)).norm(), 1e-15);
    EXPECT_LT((coons_point(sides, 0, t) - sides[2](t)).norm(), 1e-15);
    EXPECT_LT((coons_point(sides, 1, t) - sides[3](t)).norm(), 1e-15);
  }
  // By hand: half of both pairs of sides, less a quarter of the corners.
  const Eigen::Vector2d middle =
      0.5 * (sides[0](0.5) + sides[1](0.5) + sides[2](0.5) + sides[3](0.5)) - 0.25 * Eigen::Vector2d(2, 2);
  EXPECT_LT((coons_point(sides, 0.5, 0.5) - middle).norm(), 1e-15);
}

}  // namespace
}  // namespace isopatch::segmentation
