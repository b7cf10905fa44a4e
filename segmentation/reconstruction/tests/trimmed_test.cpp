#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/brep/check_brep.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "segmentation/reconstruction/internal/fit_surface.hpp"
#include "segmentation/reconstruction/internal/region_map.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"
#include "segmentation/reconstruction/tests/grid_mesh.hpp"

namespace isopatch::segmentation {
namespace {

using test::add_grid;

double hill(double x, double y) {
  return 0.5 + 0.1 * std::sin(std::numbers::pi * x) * std::cos(2 * y);
}

/// A unit square's prism under the hill.
geometry::TriangleMesh hill_block(int n) {
  geometry::TriangleMesh mesh;
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(u, v, hill(u, v)); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(v, u, 0); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(u, 0, v * hill(u, 0)); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(1 - u, 1, v * hill(1 - u, 1)); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(0, 1 - u, v * hill(0, 1 - u)); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(1, u, v * hill(1, u)); });
  return mesh;
}

TEST(TrimmedFace, OverABlockComesBackFromItsTriangles) {
  const Reconstruction made = reconstruct(hill_block(8));
  EXPECT_EQ(kinds_text(made.regions), "1 freeform surface, 5 planes");
  EXPECT_EQ(made.brep.edges().size(), 12u);
  // The integral of the hill: sin over half a turn is 2 / pi, cos(2 y) is sin(2) / 2.
  const double volume = 0.5 + 0.1 * 2 / std::numbers::pi * std::sin(2.0) / 2;
  const double chord = std::abs(made.report.mesh_volume - volume);
  EXPECT_GT(chord, 1e-4);
  // Splines through vertices are of fourth order: two halvings of the chord error's second at 8 intervals.
  EXPECT_LT(std::abs(made.brep.volume() - volume), 0.05 * chord);
  EXPECT_TRUE(geometry::check(made.brep).contradictions.empty());
  EXPECT_LT(made.report.largest_deviation, 1e-4 * made.brep.size());
}

/// Three quarters of a hemisphere's band: no plane sees all of it.
geometry::TriangleMesh bent_band(int n) {
  geometry::TriangleMesh mesh;
  add_grid(mesh, n, [](double u, double v) {
    const double turn = 1.5 * std::numbers::pi * u, rise = 0.1 + v;
    return Eigen::Vector3d(std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise));
  });
  return mesh;
}

TEST(RegionMap, TurnsNoTriangleOfABentBandOver) {
  const geometry::TriangleMesh mesh = bent_band(12);
  // What is across the open mesh's border is of another region.
  geometry::MeshNeighbours neighbours = geometry::neighbours(mesh);
  for (auto& sides : neighbours.across)
    for (auto& side : sides)
      if (side.triangle < 0) side.triangle = static_cast<int>(mesh.triangles.cols());
  Regions regions;
  regions.regions.resize(2);
  for (int t = 0; t < mesh.triangles.cols(); ++t) regions.regions[0].triangles.push_back(t);
  regions.of_triangle.assign(static_cast<std::size_t>(mesh.triangles.cols()), 0);
  regions.of_triangle.push_back(1);
  const auto map = region_map(mesh, neighbours, regions, 0, {0, 12, 13 * 12, 13 * 13 - 1});
  ASSERT_TRUE(map);
  ASSERT_EQ(map->vertices.size(), 169u);
  Eigen::Matrix2Xd place(2, 169);
  for (std::size_t i = 0; i < 169; ++i)
    place.col(map->vertices[i]) = map->places.col(static_cast<Eigen::Index>(i));
  for (const auto& t : mesh.triangles.colwise()) {
    Eigen::Matrix2d sides;
    sides << place.col(t[1]) - place.col(t[0]), place.col(t[2]) - place.col(t[0]);
    EXPECT_GT(sides.determinant(), 0);
  }
}

TEST(FitSurface, KeepsAPlaneAndHalvesKnotsAcrossAWave) {
  const int n = 24;
  PlacedPoints plane{Eigen::Matrix3Xd(3, (n + 1) * (n + 1)), Eigen::Matrix2Xd(2, (n + 1) * (n + 1)),
                     Eigen::VectorXd::Ones((n + 1) * (n + 1))};
  PlacedPoints wave = plane;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double u = double(i) / n, v = double(j) / n;
      const Eigen::Index at = i + (n + 1) * j;
      plane.places.col(at) = wave.places.col(at) = Eigen::Vector2d(u, v);
      plane.points.col(at) << u, v, 0.2 * u;
      wave.points.col(at) << u, v, 0.1 * std::sin(9 * u);
    }
  const FittedSurface one = fit_surface(plane, 1e-5);
  EXPECT_EQ(one.surface.size(), 16);
  EXPECT_LE(one.off.maxCoeff<Eigen::PropagateNaN>(), 1e-5);
  const FittedSurface two = fit_surface(wave, 1e-5);
  EXPECT_GT(two.surface.size(0), 4 * two.surface.size(1));
  EXPECT_LE(two.off.maxCoeff<Eigen::PropagateNaN>(), 1e-5);
}

}  // namespace
}  // namespace isopatch::segmentation
