#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/mesh/mend.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "segmentation/reconstruction/internal/fit_curves.hpp"
#include "segmentation/reconstruction/internal/split_bands.hpp"
#include "segmentation/reconstruction/internal/steady_curve.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"
#include "segmentation/reconstruction/tests/grid_mesh.hpp"

namespace isopatch::segmentation {
namespace {

using test::add_grid;

Eigen::Matrix3Xd half_circle(int sides) {
  Eigen::Matrix3Xd points(3, sides + 1);
  for (int i = 0; i <= sides; ++i) {
    const double turn = std::numbers::pi * i / sides;
    points.col(i) << std::cos(turn), std::sin(turn), 0;
  }
  return points;
}

TEST(Waviness, OfAnArcIsOneHoweverFewItsVerticesAre) {
  // Chords of 400 sides are shorter than the arc by (pi / 400)^2 / 24 = 2.6e-6.
  for (const int sides : {4, 7, 40}) EXPECT_NEAR(waviness(half_circle(400), half_circle(sides)), 1, 3e-6);
}

// One side has no vertices inside at which it could turn.
TEST(Waviness, OfALineOverOneSideIsOne) {
  Eigen::Matrix3Xd side(3, 2);
  side << 1, 4, 2, 6, 3, 3;
  EXPECT_EQ(waviness(side, side), 1);
}

TEST(Waviness, OfWavesBetweenVerticesIsTheirLength) {
  // A sine wave of amplitude a and length l is longer than its line by (pi a / l)^2.
  Eigen::Matrix3Xd line(3, 801), polygon(3, 5);
  for (int i = 0; i <= 800; ++i) line.col(i) << i / 800.0, 0.02 * std::sin(8 * std::numbers::pi * i / 800), 0;
  for (int i = 0; i <= 4; ++i) polygon.col(i) << i / 4.0, 0, 0;
  EXPECT_NEAR(waviness(line, polygon) - 1, std::pow(std::numbers::pi * 0.02 / 0.25, 2), 4e-3);
}

TEST(SteadyCurve, HasNoWavesAndDoesNotRunBack) {
  const Eigen::Matrix3Xd polygon = half_circle(12);
  const geometry::NurbsCurve arc = fit_curves({by_length(polygon)}, 1e-4).curves.front();
  EXPECT_TRUE(is_steady(arc, polygon));
  Eigen::Matrix3Xd waved = arc.control_points(), back = waved;
  for (Eigen::Index i = 1; i + 1 < waved.cols(); ++i) waved.col(i) *= i % 2 == 0 ? 1.2 : 0.8;
  EXPECT_FALSE(is_steady(geometry::NurbsCurve(arc.knots(), waved), polygon));
  // Two control points in each other's place, near enough for the length to stay.
  const Eigen::Index middle = back.cols() / 2;
  back.col(middle).swap(back.col(middle + 1));
  EXPECT_FALSE(is_steady(geometry::NurbsCurve(arc.knots(), back), polygon));
}

constexpr int columns = 16, rows = 2;

TEST(SteadyCurve, FarthestFromItsPolygonIsMeasuredBetweenVertices) {
  // An arc is off its chords by 1 - cos of half their angle.
  const Eigen::Matrix3Xd polygon = half_circle(12);
  const geometry::NurbsCurve arc = fit_curves({by_length(half_circle(200))}, 1e-7).curves.front();
  EXPECT_NEAR(farthest(arc, polygon), 1 - std::cos(std::numbers::pi / 24), 1e-4);
}

/// Three columns of vertices to the left of the middle, thirteen to the right.
double column(double u) {
  return u < 3.0 / 16 ? u * 8 / 3 : 0.5 + (u - 3.0 / 16) * 8 / 13;
}

/// A block whose front is a freeform wall, of which the right half is curved ten times as much as the left
/// one; straight from the bottom to the top but for a bulge.
geometry::TriangleMesh walled_block(double bulge) {
  const auto depth = [](double x) {
    const double right = std::max(0.0, x - 0.5);
    return 0.05 * std::sin(2 * x) + 0.8 * right * right * (1 - right);
  };
  const auto level = [=](double u, double w, double v) {
    const double x = column(u),
                 y = -(1 - 0.3 * v) * depth(x) - bulge * 4 * v * (1 - v) * std::sin(std::numbers::pi * x);
    return Eigen::Vector3d(x, y + w * (1 - y), 0.5 * v);
  };
  geometry::TriangleMesh mesh;
  add_grid(mesh, columns, rows, [=](double u, double v) { return level(u, 0, v); });
  add_grid(mesh, rows, columns, [=](double v, double u) { return level(u, 1, v); });
  add_grid(mesh, columns, 1, [=](double u, double w) { return level(u, w, 1); });
  add_grid(mesh, 1, columns, [=](double w, double u) { return level(u, w, 0); });
  add_grid(mesh, rows, 1, [=](double v, double w) { return level(0, w, v); });
  add_grid(mesh, 1, rows, [=](double w, double v) { return level(1, w, v); });
  return geometry::mended(mesh, 1e-12).mesh;
}

int straight_faces(const Reconstruction& made) {
  return static_cast<int>(std::count_if(
      made.regions.regions.begin(), made.regions.regions.end(),
      [](const Region& region) { return region.spline && region.spline->knots(1).degree() == 1; }));
}

TEST(FreeformWall, IsDividedAtASeamOfSeveralEdges) {
  const Reconstruction made = reconstruct(walled_block(0));
  EXPECT_EQ(straight_faces(made), 2);
  EXPECT_EQ(kinds_text(made.regions), "5 planes, 2 freeform surfaces");
}

TEST(FreeformWall, IsStraightIfItBendsByLittleOfItsHeight) {
  // Of a height of 1/2.
  const Reconstruction little = reconstruct(walled_block(1e-3));
  EXPECT_EQ(straight_faces(little), 2);
  EXPECT_NEAR(little.report.largest_deviation, 1e-3, 2e-4);
  EXPECT_TRUE(geometry::check(little.brep).contradictions.empty());
}

TEST(FreeformWall, IsRefusedIfAnEdgeOfItWouldWaveBetweenItsVertices) {
  // It bends by more than straight walls may, and is far from flat where vertices are few.
  EXPECT_ERROR(reconstruct(walled_block(4e-3)), ErrorCode::unsupported, "waves between its vertices");
}

}  // namespace
}  // namespace isopatch::segmentation
