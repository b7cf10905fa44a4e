#include "segmentation/profiles/settled.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/base/larger.hpp"
#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/profiles/tests/division_check.hpp"
#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation {
namespace {

using drawings::Vector2d;

/// A square whose third corner has moved towards the first.
Profile kite(double corner) {
  return drawings::outline({{0, 0}, {1, 0}, {corner, corner}, {0, 1}});
}

double least_jacobian(const Profile& profile, const Quadrangulation& quads) {
  double least = 1;
  for (int q = 0; q < static_cast<int>(quads.quads.size()); ++q)
    least = smaller(least, shape_of(profile, quads, q).jacobian);
  return least;
}

/// A square in four around a vertex inside.
Quadrangulation square_in_four(const Vector2d& inside) {
  Quadrangulation result;
  result.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}, inside};
  for (int k = 0; k < 4; ++k) {
    result.edges.push_back({k, 4 + k, k, 0, 0.5});
    result.edges.push_back({4 + k, (k + 1) % 4, k, 0.5, 1});
  }
  for (int k = 0; k < 4; ++k) result.edges.push_back({4 + k, 8, -1});
  const auto use = [](int edge, bool reversed) { return geometry::EdgeUse{EdgeId(edge), reversed}; };
  for (int k = 0; k < 4; ++k)
    result.quads.push_back(
        {0, {use(2 * k, false), use(8 + k, false), use(8 + (k + 3) % 4, true), use((2 * k + 7) % 8, false)}});
  return result;
}

TEST(Settled, MovesAVertexInsideOutOfACorner) {
  const Profile profile = drawings::square();
  const Quadrangulation quads = square_in_four({0.72, 0.72});  // almost straight across its corner
  ASSERT_EQ(checks::fault_of(profile, quads), "");
  EXPECT_LT(least_jacobian(profile, quads), 0.25);
  const std::vector<double> upright(quads.vertices.size(), 1);
  const Quadrangulation moved = settled(quads, {profile}, upright);
  EXPECT_EQ(checks::fault_of(profile, moved), "");
  EXPECT_GT(least_jacobian(profile, moved), 0.6);
}

// Vertices inside follow the mean of their neighbours, here two cuts that move and two that do not.
TEST(Settled, SuitsSeveralDrawingsAtOnce) {
  const Profile square = kite(1), dented = kite(0.62);
  const Quadrangulation quads = square_in_four({0.7, 0.7});
  const std::vector<double> upright(quads.vertices.size(), 1);
  const auto there = [&](Quadrangulation at) {
    const auto cut = [&](int k) {
      const QuadEdge& half = at.edges[static_cast<std::size_t>(2 * k)];
      const Vector2d from = dented.vertices[static_cast<std::size_t>(k)],
                     to = dented.vertices[static_cast<std::size_t>((k + 1) % 4)];
      return Vector2d(from + half.high * (to - from));
    };
    Vector2d sum = Vector2d::Zero();
    for (int k = 0; k < 4; ++k) {
      Vector2d& vertex = at.vertices[static_cast<std::size_t>(4 + k)];
      sum += cut(k) - vertex;
      vertex = cut(k);
    }
    at.vertices.back() += sum / 4;
    std::copy(dented.vertices.begin(), dented.vertices.end(), at.vertices.begin());
    return at;
  };
  EXPECT_LT(least_jacobian(dented, there(quads)), 0);
  const Quadrangulation moved = settled(quads, {square, dented}, upright);
  EXPECT_EQ(checks::fault_of(square, moved), "");
  EXPECT_EQ(checks::fault_of(dented, there(moved)), "");
  EXPECT_GT(least_jacobian(dented, there(moved)), 0.4);
}

// Rectangles are all as good by their Jacobians, which are 1.
TEST(Settled, WidensNeedles) {
  const Profile profile = drawings::square();
  Quadrangulation quads = square_in_four({0.99, 0.5});
  quads.vertices[4] = {0.99, 0};
  quads.vertices[6] = {0.99, 1};
  quads.edges[0].high = quads.edges[1].low = 0.99;
  quads.edges[4].high = quads.edges[5].low = 0.01;
  ASSERT_EQ(checks::fault_of(profile, quads), "");
  const auto most_slender = [&](const Quadrangulation& division) {
    double most = 1;
    for (int q = 0; q < 4; ++q) most = larger(most, shape_of(profile, division, q).slenderness);
    return most;
  };
  EXPECT_NEAR(most_slender(quads), 50, 1e-9);  // 0.5 by 0.01
  const std::vector<double> upright(quads.vertices.size(), 1);
  const Quadrangulation moved = settled(quads, {profile}, upright);
  EXPECT_EQ(checks::fault_of(profile, moved), "");
  EXPECT_LT(most_slender(moved), 3);
  EXPECT_GT(least_jacobian(profile, moved), 0.99);
}

TEST(Settled, LeavesRightAnglesAsTheyAre) {
  const Profile profile = drawings::square();
  const Quadrangulation quads = quadrangulate(profile);
  const Quadrangulation moved = settled(quads, {profile}, std::vector<double>(quads.vertices.size(), 1));
  EXPECT_EQ(moved.vertices, quads.vertices);
  EXPECT_EQ(moved.quads.size(), quads.quads.size());
}

}  // namespace
}  // namespace isopatch::segmentation
