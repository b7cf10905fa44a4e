#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <set>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/mesh/mend.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/polygon_triangles.hpp"
#include "geometry/mesh/weld.hpp"

namespace isopatch::geometry {
namespace {

/// A cube of side `side`, from a corner on; twelve triangles of eight vertices.
TriangleMesh cube(const Eigen::Vector3d& corner = Eigen::Vector3d::Zero(), double side = 1) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 8);
  for (int i = 0; i < 8; ++i)
    mesh.vertices.col(i) = corner + side * Eigen::Vector3d(i & 1, (i >> 1) & 1, i >> 2);
  mesh.triangles.resize(3, 12);
  mesh.triangles << 0, 0, 4, 4, 0, 0, 2, 2, 0, 0, 1, 1,  //
      2, 3, 5, 7, 1, 5, 7, 6, 4, 6, 3, 7,                //
      3, 1, 7, 6, 5, 4, 3, 7, 6, 2, 7, 5;
  return mesh;
}

/// With each triangle's vertices for itself, moved by at most `noise`.
TriangleMesh apart(const TriangleMesh& mesh, double noise) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> off(-noise, noise);
  TriangleMesh result;
  result.vertices.resize(3, 3 * mesh.triangles.cols());
  result.triangles.resize(3, mesh.triangles.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      result.vertices.col(3 * t + i) =
          mesh.vertices.col(mesh.triangles(i, t)) + Eigen::Vector3d(off(random), off(random), off(random));
      result.triangles(i, t) = static_cast<int>(3 * t) + i;
    }
  return result;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh result = a;
  result.vertices.conservativeResize(3, a.vertices.cols() + b.vertices.cols());
  result.vertices.rightCols(b.vertices.cols()) = b.vertices;
  result.triangles.conservativeResize(3, a.triangles.cols() + b.triangles.cols());
  result.triangles.rightCols(b.triangles.cols()) = b.triangles.array() + static_cast<int>(a.vertices.cols());
  return result;
}

void turn(TriangleMesh& mesh, Eigen::Index t) {
  std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
}

TEST(TriangleMesh, MeasuresACube) {
  const TriangleMesh mesh = cube({5, 6, 7}, 2);
  EXPECT_NEAR(volume(mesh), 8, 1e-12);
  EXPECT_NEAR(area(mesh), 24, 1e-12);
  EXPECT_NEAR(diagonal(mesh), 2 * std::sqrt(3), 1e-12);
}

TEST(Weld, MergesWhatIsNearerThanTheToleranceAndNothingElse) {
  const TriangleMesh loose = apart(cube(), 1e-6);
  const Welded welded = weld(loose, 1e-5);
  EXPECT_EQ(welded.mesh.vertices.cols(), 8);
  EXPECT_EQ(welded.vertices, 28);
  EXPECT_EQ(welded.mesh.triangles.cols(), 12);
  EXPECT_EQ(weld(loose, 0).mesh.vertices.cols(), 36);
  EXPECT_EQ(weld(apart(cube(), 0), 0).mesh.vertices.cols(), 8);
}

TEST(Weld, LeavesOutTrianglesThatVanish) {
  TriangleMesh mesh = cube();
  mesh.vertices.col(1) = mesh.vertices.col(0) + Eigen::Vector3d(1e-9, 0, 0);
  const Welded welded = weld(mesh, 1e-6);
  EXPECT_EQ(welded.degenerate, 2);
  EXPECT_TRUE(neighbours(welded.mesh).closed());
  EXPECT_ERROR(weld(mesh, -1), ErrorCode::invalid_argument, "tolerance");
}

TEST(MeshNeighbours, AreThoseAcrossEachSide) {
  const TriangleMesh mesh = cube();
  const MeshNeighbours found = neighbours(mesh);
  ASSERT_TRUE(found.closed());
  for (int t = 0; t < 12; ++t)
    for (int i = 0; i < 3; ++i) {
      const TriangleSide other = found.across[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)];
      EXPECT_EQ(mesh.triangles(i, t), mesh.triangles((other.side + 1) % 3, other.triangle));
      EXPECT_EQ(mesh.triangles((i + 1) % 3, t), mesh.triangles(other.side, other.triangle));
      const TriangleSide back =
          found.across[static_cast<std::size_t>(other.triangle)][static_cast<std::size_t>(other.side)];
      EXPECT_EQ(back, (TriangleSide{t, i}));
    }
}

TEST(Mend, TurnsWhatDoesNotAgreeAndLeavesOutCopies) {
  TriangleMesh mesh = cube();
  turn(mesh, 3);
  turn(mesh, 8);
  mesh.triangles.conservativeResize(3, 13);
  mesh.triangles.col(12) = mesh.triangles.col(0);
  const MendedMesh mended_mesh = mended(mesh, 0);
  EXPECT_TRUE(neighbours(mended_mesh.mesh).closed());
  EXPECT_NEAR(volume(mended_mesh.mesh), 1, 1e-12);
  EXPECT_EQ(mended_mesh.remarks,
            (std::vector<std::string>{"1 triangle that occurs twice was left out",
                                      "2 triangles did not agree with their neighbours and were turned"}));
}

TEST(Mend, TurnsShellsThatAreInsideOut) {
  TriangleMesh mesh = cube();
  for (Eigen::Index t = 0; t < 12; ++t) turn(mesh, t);
  const MendedMesh one = mended(mesh, 0);
  EXPECT_NEAR(volume(one.mesh), 1, 1e-12);
  EXPECT_EQ(one.remarks, std::vector<std::string>{"1 shell was inside out and was turned"});
  // A cavity looks inwards, whatever it did before.
  const MendedMesh hollow = mended(joined(cube(), cube({0.25, 0.25, 0.25}, 0.5)), 0);
  EXPECT_NEAR(volume(hollow.mesh), 1 - 0.125, 1e-12);
}

TEST(Mend, RefusesWhatBoundsNoSolidAndSaysWhere) {
  TriangleMesh open = cube();
  open.triangles.conservativeResize(3, 11);
  EXPECT_ERROR(mended(open, 0), ErrorCode::not_manifold,
               "3 edges have one triangle only, among them the edge from (");
  EXPECT_ERROR(mended(joined(cube(), cube({1, 1, 0})), 0), ErrorCode::not_manifold,
               "1 edge has more than two triangles");
  EXPECT_ERROR(mended(joined(cube(), cube({3, 0, 0})), 0), ErrorCode::not_manifold,
               "2 bodies that lie beside each other");
  EXPECT_ERROR(mended(TriangleMesh{}, 0), ErrorCode::bad_format, "no triangles");
  // The projective plane of six vertices: closed, two triangles at each edge, with one side.
  TriangleMesh one_sided;
  one_sided.vertices = Eigen::Matrix3Xd::Random(3, 6);
  one_sided.triangles.resize(3, 10);
  one_sided.triangles << 0, 0, 0, 0, 0, 1, 1, 1, 2, 3,  //
      1, 1, 2, 2, 3, 2, 2, 3, 4, 4,                     //
      4, 5, 3, 5, 4, 3, 4, 5, 5, 5;
  EXPECT_ERROR(mended(one_sided, 0), ErrorCode::not_manifold, "has one side only");
}

TEST(PolygonTriangles, CoverConcavePolygonsWithTheirArea) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int round = 0; round < 50; ++round) {
    const int n = 3 + round % 12;
    Eigen::Matrix3Xd star(3, n);
    std::vector<int> polygon;
    Eigen::Vector3d twice = Eigen::Vector3d::Zero();
    for (int i = 0; i < n; ++i) {
      const double turn_to = 2 * M_PI * i / n, r = radius(random);
      star.col(i) << r * std::cos(turn_to), r * std::sin(turn_to), 0.3;
      polygon.push_back(i);
    }
    for (int i = 0; i < n; ++i) twice += star.col(i).cross(star.col((i + 1) % n));
    const Eigen::Matrix3Xi triangles = polygon_triangles(star, polygon);
    double sum = 0;
    for (const auto& t : triangles.colwise()) {
      const Eigen::Vector3d part = (star.col(t[1]) - star.col(t[0])).cross(star.col(t[2]) - star.col(t[0]));
      EXPECT_GT(part.z(), 0);
      sum += part.z();
    }
    EXPECT_NEAR(sum, twice.z(), 1e-12);
  }
  Eigen::Matrix3Xd crossed(3, 4);
  crossed << 0, 1, 0, 0.9, 0, 1, 1, 0.1, 0, 0, 0, 0;
  EXPECT_ERROR(polygon_triangles(crossed, {0, 1, 2, 3}), ErrorCode::bad_format, "crosses itself");
}

}  // namespace
}  // namespace isopatch::geometry
