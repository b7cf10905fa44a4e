#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/mesh/mend.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "segmentation/reconstruction/internal/bent_borders.hpp"
#include "segmentation/reconstruction/internal/chance_planes.hpp"
#include "segmentation/reconstruction/internal/dented_planes.hpp"
#include "segmentation/reconstruction/internal/without_rounds.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"
#include "segmentation/reconstruction/tests/grid_mesh.hpp"

namespace isopatch::segmentation {
namespace {

using test::add_grid;

/// A unit cube whose top is at other heights, which are 1 along its border.
geometry::TriangleMesh cube(int n, const auto& top) {
  geometry::TriangleMesh mesh;
  add_grid(mesh, n, [&](double u, double v) { return Eigen::Vector3d(u, v, top(u, v)); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(v, u, 0); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(u, 0, v); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(1 - u, 1, v); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(0, 1 - u, v); });
  add_grid(mesh, n, [](double u, double v) { return Eigen::Vector3d(1, u, v); });
  return mesh;
}

TEST(DentedPlanes, OfOneVertexAreOneFaceAndSaidToBeDented) {
  const double depth = 4e-4;
  const geometry::TriangleMesh mesh =
      cube(8, [&](double u, double v) { return u == 0.5 && v == 0.5 ? 1 - depth : 1.0; });
  const Reconstruction made = reconstruct(mesh);
  EXPECT_EQ(kinds_text(made.regions), "6 planes");
  EXPECT_NEAR(made.report.largest_deviation, depth, 0.05 * depth);
  EXPECT_NEAR(made.brep.volume(), 1, 1e-5);
}

TEST(DentedPlanes, KeepTheStripsOfARoundBesideThem) {
  // Strips of a round of radius 0.2 from the plane z = 1 on, one degree each: the first is within 3e-5 of it.
  geometry::TriangleMesh mesh;
  const auto round = [](double share) {
    const double turn = share * std::numbers::pi / 2;
    return Eigen::Vector3d(0.2 * std::sin(turn), 0, 0.8 + 0.2 * std::cos(turn));
  };
  const int strips = 90;
  mesh.vertices.resize(3, 2 * (strips + 2));
  mesh.triangles.resize(3, 2 * (strips + 1));
  for (int i = 0; i <= strips + 1; ++i) {
    const Eigen::Vector3d at = i == 0 ? Eigen::Vector3d(-1, 0, 1) : round(double(i - 1) / strips);
    mesh.vertices.col(2 * i) = at;
    mesh.vertices.col(2 * i + 1) = at + Eigen::Vector3d(0, 1, 0);
  }
  for (int i = 0; i <= strips; ++i) {
    mesh.triangles.col(2 * i) << 2 * i, 2 * i + 2, 2 * i + 3;
    mesh.triangles.col(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 1;
  }
  const geometry::MeshNeighbours neighbours = geometry::neighbours(mesh);
  const Facets facets = plane_facets(mesh, neighbours, 1e-7);
  ASSERT_EQ(facets.facets.size(), 91u);
  EXPECT_EQ(without_dents(mesh, neighbours, facets, 1e-4).facets.size(), 91u);
}

double dome(double u, double v) {
  return 1 + 0.2 * std::sin(std::numbers::pi * u) * std::sin(std::numbers::pi * v);
}

TEST(ChancePlanes, BelongToTheFreeformFaceAround) {
  const geometry::TriangleMesh mesh = geometry::mended(cube(8, dome), 0).mesh;
  Regions regions = find_regions(mesh);
  ASSERT_EQ(kinds_text(regions), "1 freeform surface, 5 planes");
  // A triangle amid the dome as a plane of its own.
  const int alone = regions.regions[0].triangles[60];
  Region plane;
  const Eigen::Vector3d normal = geometry::area_vector(mesh, alone);
  plane.carrier = geometry::Carrier{geometry::SurfaceKind::plane,
                                    mesh.vertices.col(mesh.triangles(0, alone)),
                                    normal.normalized(),
                                    0,
                                    0,
                                    {}};
  plane.area = normal.norm() / 2;
  plane.triangles = {alone};
  std::erase(regions.regions[0].triangles, alone);
  regions.of_triangle[static_cast<std::size_t>(alone)] = static_cast<int>(regions.regions.size());
  regions.regions.push_back(plane);
  const Regions joined =
      without_chance_planes(mesh, geometry::neighbours(mesh), regions, Angle::degrees(41), 1e-6);
  ASSERT_EQ(joined.regions.size(), 6u);
  EXPECT_EQ(joined.of_triangle[static_cast<std::size_t>(alone)], 0);
  EXPECT_EQ(joined.regions[0].triangles.size(), 128u);
}

constexpr int around_post = 96;
constexpr int post_rows = 11;  // two of the wall, which the round begins in, and the round's
constexpr double post_height = 0.5, post_round = 0.05;

/// A closed curve without straight or circular parts, and the way outwards.
Eigen::Vector3d post_outline(double turn) {
  const double radius = 1 + 0.15 * std::cos(3 * turn);
  return {radius * std::cos(turn), radius * std::sin(turn), 0};
}
Eigen::Vector3d post_outwards(double turn) {
  const Eigen::Vector3d along = post_outline(turn + 1e-5) - post_outline(turn - 1e-5);
  return along.cross(Eigen::Vector3d::UnitZ()).normalized();
}

/// An upright post with a round of nine strips along its top.
geometry::TriangleMesh rounded_post(int around = around_post) {
  geometry::TriangleMesh mesh;
  mesh.vertices.resize(3, post_rows * around + 2);
  mesh.triangles.resize(3, 2 * (post_rows - 1) * around + 2 * around);
  Eigen::Index count = 0;
  for (int row = 0; row < post_rows; ++row)
    for (int i = 0; i < around; ++i) {
      const double turn = 2 * std::numbers::pi * i / around,
                   rise = std::max(0, row - 1) * std::numbers::pi / 2 / (post_rows - 2);
      Eigen::Vector3d at = post_outline(turn) + post_round * (std::cos(rise) - 1) * post_outwards(turn);
      at.z() = row == 0 ? 0 : post_height - post_round + post_round * std::sin(rise);
      mesh.vertices.col(row * around + i) = at;
    }
  for (int row = 0; row + 1 < post_rows; ++row)
    for (int i = 0; i < around; ++i) {
      const int a = row * around + i, b = row * around + (i + 1) % around;
      mesh.triangles.col(count++) << a, b, b + around;
      mesh.triangles.col(count++) << a, b + around, a + around;
    }
  const int low = post_rows * around, high = low + 1, top = (post_rows - 1) * around;
  mesh.vertices.col(low) << 0, 0, 0;
  mesh.vertices.col(high) << 0, 0, post_height;
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    mesh.triangles.col(count++) << next, i, low;
    mesh.triangles.col(count++) << top + i, top + next, high;
  }
  return mesh;
}

/// Regions of a post: its side is freeform but for some triangles, its ends are planes.
/// @param on_cylinder  triangles of the side, in ascending order
Regions regions_of_post(const geometry::TriangleMesh& mesh, int around, const std::vector<int>& on_cylinder) {
  Regions result;
  result.regions.resize(4);
  for (int t = 0; t < static_cast<int>(mesh.triangles.cols()); ++t) {
    const int end = t - 2 * (post_rows - 1) * around;
    const bool chosen = std::binary_search(on_cylinder.begin(), on_cylinder.end(), t);
    result.of_triangle.push_back(end >= 0 ? 1 + end % 2 : chosen ? 3 : 0);
    Region& region = result.regions[static_cast<std::size_t>(result.of_triangle.back())];
    region.triangles.push_back(t);
    region.area += geometry::area_vector(mesh, t).norm() / 2;
  }
  for (const std::size_t r : {1, 2, 3}) {
    geometry::Carrier& carrier = result.regions[r].carrier.emplace();
    carrier.kind = r == 3 ? geometry::SurfaceKind::cylinder : geometry::SurfaceKind::plane;
    carrier.axis = {0, 0, r == 1 ? -1.0 : 1.0};
  }
  return result;
}

TEST(ChancePlanes, OfManyTimesTheAreaOfTrianglesAroundAreFaces) {
  constexpr int around = 8;
  const geometry::TriangleMesh mesh = rounded_post(around);
  Regions regions = regions_of_post(mesh, around, {});
  regions.regions.pop_back();
  const Regions kept =
      without_chance_planes(mesh, geometry::neighbours(mesh), regions, Angle::degrees(41), 1e-6);
  ASSERT_EQ(kept.regions.size(), 3u);
  EXPECT_EQ(kept.regions[2].triangles.size(), 8u);
}

TEST(BentBorders, LoseTeethAndNotTheEndsOfASurface) {
  const geometry::TriangleMesh mesh = rounded_post();
  const geometry::MeshNeighbours neighbours = geometry::neighbours(mesh);
  const auto left = [&](const std::vector<int>& on_cylinder) {
    return without_bent_borders(mesh, neighbours, regions_of_post(mesh, around_post, on_cylinder),
                                Angle::degrees(41))
        .regions[3]
        .triangles;
  };
  std::vector<int> wall;
  for (int t = 20; t < 42; ++t) wall.push_back(t);
  EXPECT_EQ(left(wall), wall);
  std::vector<int> with_tooth = wall;
  for (const int i : {0, 1}) with_tooth.push_back(2 * (around_post + 15) + i);
  EXPECT_EQ(left(with_tooth), wall);
}

TEST(WithoutRounds, WallsReachTheirPlanes) {
  const geometry::TriangleMesh mesh = rounded_post();
  const geometry::MeshNeighbours neighbours = geometry::neighbours(mesh);
  // So strict that no torus passes for the round where the outline bends most.
  const Regions regions = find_regions(mesh, {.tolerance = 1e-8, .most_failures = 50});
  ASSERT_EQ(kinds_text(regions), "1 freeform surface, 2 planes");
  const WithoutRounds sharp = without_rounds(mesh, neighbours, regions);
  EXPECT_EQ(sharp.removed, 1);
  EXPECT_TRUE(sharp.kept.empty());
  EXPECT_TRUE(geometry::neighbours(sharp.mesh).closed());
  // The prism over the polygon: upright walls are extended to round-off.
  double area = 0;
  for (int i = 0; i < around_post; ++i) {
    const double step = 2 * std::numbers::pi / around_post;
    area += post_outline(i * step).cross(post_outline((i + 1) * step)).z() / 2;
  }
  EXPECT_NEAR(geometry::volume(sharp.mesh), area * post_height, 1e-12);
  EXPECT_NEAR(sharp.volume_change, area * post_height - geometry::volume(mesh), 1e-12);
  EXPECT_EQ(sharp.regions.regions.size(), 3u);
}

TEST(Reconstruction, EndsWhenItsTimeIsUp) {
  EXPECT_ERROR(reconstruct(cube(8, dome), {.time_limit = 1e-9}), ErrorCode::unsupported, "raise time_limit");
  EXPECT_ERROR(reconstruct(cube(2, dome), {.time_limit = 0}), ErrorCode::invalid_argument, "time_limit is 0");
}

}  // namespace
}  // namespace isopatch::segmentation
