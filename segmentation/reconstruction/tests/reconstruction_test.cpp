#include "segmentation/reconstruction/reconstruction.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/base/temporary_folder.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/write_brep.hpp"

#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/mesh/mend.hpp"
#include "segmentation/reconstruction/tests/triangulated.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::SurfaceKind;
using geometry::test::made_brep;

struct Density {
  const char* name;
  double chord, degrees;
};
const std::array<Density, 3> densities{{{"coarse", 1e-2, 28}, {"middle", 1e-3, 12}, {"fine", 1e-4, 5}}};

/// Solids whose faces are all planes, cylinders, cones, spheres and tori.
const std::vector<std::string> on_carriers{"block",      "cylinder",     "cone",        "sphere",
                                           "torus",      "drilled",      "grooved",     "notched",
                                           "round_edge", "round_corner", "countersunk", "drafted_pocket",
                                           "shaft",      "bored_boss",   "pocketed"};

class MadeSolid : public testing::TestWithParam<std::string> {};

TEST_P(MadeSolid, ComesBackFromItsTriangles) {
  const geometry::Brep given = made_brep(GetParam());
  for (const Density& density : densities) {
    SCOPED_TRACE(density.name);
    const test::Triangulated truth = test::triangulated(given, density.chord, density.degrees);
    const Reconstruction made = reconstruct(truth.mesh);
    EXPECT_EQ(test::faces_found(truth, made.mesh, made.regions), truth.faces);
    EXPECT_EQ(static_cast<int>(made.brep.faces().size()), truth.faces);
    // Coordinates of 32 bits are off by 6e-8 of the largest.
    EXPECT_NEAR(made.brep.volume() / given.volume(), 1, 2e-6);
    EXPECT_NEAR(made.brep.area() / given.area(), 1, 2e-6);
    const geometry::BrepReport report = geometry::check(made.brep);
    EXPECT_TRUE(report.contradictions.empty());
    EXPECT_LT(report.largest_gap, 1e-5 * given.size());
    EXPECT_EQ(report.topology.genus, geometry::check(given).topology.genus);
  }
}

INSTANTIATE_TEST_SUITE_P(Reconstruction, MadeSolid, testing::ValuesIn(on_carriers),
                         [](const auto& test) { return test.param; });

/// Poles are edges without length, of which a CAD kernel wants a range.
TEST(Reconstruction, SolidsWithPolesAreWrittenAndReadAgain) {
  for (const char* name : {"sphere", "cone"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    const Reconstruction made = reconstruct(test::triangulated(made_brep(name), 1e-3, 12).mesh);
    geometry::write_brep(folder.path() / "made.step", made.brep);
    const geometry::Brep again = geometry::read_brep(folder.path() / "made.step").brep;
    EXPECT_NEAR(again.volume() / made.brep.volume(), 1, 1e-9);
  }
}

/// Of this density the triangulation of a sphere has slivers that lean 30 degrees from it.
TEST(Reconstruction, SliversBelongToTheSurfaceAround) {
  const test::Triangulated truth = test::triangulated(made_brep("sphere"), 1e-2, 20);
  const Reconstruction made = reconstruct(truth.mesh);
  ASSERT_EQ(made.regions.regions.size(), 1u);
  EXPECT_NEAR(made.brep.volume() / made_brep("sphere").volume(), 1, 2e-6);
}

TEST(Reconstruction, IsExactWhereCoordinatesAre) {
  const geometry::Brep given = made_brep("drilled");
  const Reconstruction made = reconstruct(test::triangulated(given, 1e-2, 20, false).mesh);
  EXPECT_NEAR(made.brep.volume() / given.volume(), 1, 1e-12);
  EXPECT_LT(made.report.largest_deviation, 1e-14);
  const auto bore = std::find_if(made.brep.faces().begin(), made.brep.faces().end(),
                                 [](const auto& f) { return f.kind == SurfaceKind::cylinder; });
  ASSERT_NE(bore, made.brep.faces().end());
  EXPECT_EQ(bore->name, "cylinder_1");
  const geometry::Carrier carrier =
      *made.brep.carrier(FaceId(static_cast<int>(bore - made.brep.faces().begin())));
  EXPECT_NEAR(carrier.radius, 0.005, 1e-15);
  // Regular directions are those of the coordinates, exactly.
  EXPECT_EQ(carrier.axis.cwiseAbs(), Eigen::Vector3d::UnitZ());
  for (const geometry::BrepEdge& edge : made.brep.edges())
    EXPECT_TRUE(edge.kind == geometry::CurveKind::line || edge.kind == geometry::CurveKind::circle);
}

TEST(Reconstruction, EdgesOfRoundsAreLinesAndCircles) {
  const Reconstruction made = reconstruct(test::triangulated(made_brep("round_corner"), 1e-3, 12).mesh);
  for (const geometry::BrepEdge& edge : made.brep.edges())
    EXPECT_TRUE(edge.kind == geometry::CurveKind::line || edge.kind == geometry::CurveKind::circle)
        << geometry::name(edge.kind);
}

TEST(Reconstruction, MakesCarriersParallelCoaxialAndEqual) {
  const Reconstruction made = reconstruct(test::triangulated(made_brep("shaft"), 1e-3, 12).mesh);
  std::vector<geometry::Carrier> round;
  for (const Region& region : made.regions.regions)
    if (region.carrier->kind != SurfaceKind::plane) round.push_back(*region.carrier);
  ASSERT_GT(round.size(), 1u);
  for (const geometry::Carrier& carrier : round) {
    EXPECT_EQ(carrier.axis.cross(round[0].axis).norm(), 0);
    EXPECT_LT((carrier.origin - round[0].origin).cross(round[0].axis).norm(), 1e-16);
  }
}

TEST(Reconstruction, NamesFacesByKindInTheOrderOfArea) {
  const Reconstruction made = reconstruct(test::triangulated(made_brep("round_edge"), 1e-3, 12).mesh);
  std::vector<std::string> names;
  for (const geometry::BrepFace& face : made.brep.faces()) names.push_back(face.name);
  EXPECT_EQ(names, (std::vector<std::string>{"plane_1", "plane_2", "plane_3", "plane_4", "plane_5", "plane_6",
                                             "cylinder_1"}));
  EXPECT_EQ(kinds_text(made.regions), "6 planes, 1 cylinder");
  for (std::size_t f = 1; f < made.regions.regions.size(); ++f)
    EXPECT_GE(made.regions.regions[f - 1].area, made.regions.regions[f].area);
}

TEST(Reconstruction, AllowsForTheRoundingOfTheFile) {
  geometry::TriangleMesh mesh = test::triangulated(made_brep("drilled"), 1e-3, 12, false).mesh;
  // As a program writes that knows six digits: 0.0123456.
  mesh.vertices = (mesh.vertices * 1e7).array().round() / 1e7;
  mesh.grain = 1e-7;
  EXPECT_EQ(kinds_text(reconstruct(mesh).regions), "6 planes, 1 cylinder");
}

TEST(Reconstruction, TakesVerticesThatAreOnlyNearTheirSurfacesAndSaysSo) {
  const test::Triangulated truth = test::triangulated(made_brep("drilled"), 1e-3, 12, false);
  geometry::TriangleMesh mesh = geometry::mended(truth.mesh, 0).mesh;
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v)
    mesh.vertices.col(v) += 2e-7 * Eigen::Vector3d(std::sin(7.0 * double(v)), std::sin(11.0 * double(v)),
                                                   std::sin(13.0 * double(v)));
  const Reconstruction made = reconstruct(mesh);
  EXPECT_EQ(kinds_text(made.regions), "6 planes, 1 cylinder");
  ASSERT_EQ(made.report.remarks.size(), 1u);
  EXPECT_NE(made.report.remarks[0].find("off the surfaces"), std::string::npos);
}

TEST(Reconstruction, WorksFarFromTheOrigin) {
  geometry::TriangleMesh mesh = test::triangulated(made_brep("drilled"), 1e-3, 12, false).mesh;
  mesh.vertices.colwise() += Eigen::Vector3d(1, 2, 0);
  mesh = geometry::read_stl(geometry::to_stl(mesh), "far.stl");
  const Reconstruction made = reconstruct(mesh);
  EXPECT_EQ(kinds_text(made.regions), "6 planes, 1 cylinder");
}

TEST(Reconstruction, FindsTheSameFacesAtAnyScaleAndInAnyPosition) {
  const geometry::TriangleMesh mesh = test::triangulated(made_brep("drilled"), 1e-3, 12, false).mesh;
  const Reconstruction first = reconstruct(mesh);
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const double scale : {1e-3, 0.37, 1e6})
    for (const bool single : {false, true}) {
      geometry::TriangleMesh other = mesh;
      other.vertices = scale * turned * mesh.vertices;
      if (single) other = geometry::read_stl(geometry::to_stl(other), "turned.stl");
      const Reconstruction made = reconstruct(other);
      EXPECT_EQ(kinds_text(made.regions), kinds_text(first.regions)) << scale << single;
      // 32 bits round the vertices by 6e-8 of the largest coordinate, a thickness by as much of some
      // thirtieth.
      EXPECT_NEAR(made.brep.volume() / (first.brep.volume() * std::pow(scale, 3)), 1, single ? 1e-5 : 1e-9);
    }
}

TEST(Reconstruction, RefusesFreeformFacesAndSaysWhere) {
  EXPECT_ERROR(reconstruct(test::triangulated(made_brep("spring"), 1e-3, 12).mesh), ErrorCode::unsupported,
               "no plane, cylinder, cone, sphere or torus");
}

TEST(Reconstruction, RefusesOpenMeshes) {
  geometry::TriangleMesh mesh = test::triangulated(made_brep("block"), 1e-3, 12).mesh;
  mesh.triangles.conservativeResize(3, mesh.triangles.cols() - 1);
  EXPECT_ERROR(reconstruct(mesh), ErrorCode::not_manifold, "3 edges have one triangle only");
}

TEST(Reconstruction, OptionsAreChecked) {
  const geometry::TriangleMesh mesh = test::triangulated(made_brep("block"), 1e-3, 12).mesh;
  EXPECT_ERROR(reconstruct(mesh, {.tolerance = 0}), ErrorCode::invalid_argument, "tolerance is 0");
  EXPECT_ERROR(reconstruct(mesh, {.smooth = Angle::degrees(90)}), ErrorCode::invalid_argument,
               "smooth is 90");
  EXPECT_ERROR(reconstruct(mesh, {.large = -1}), ErrorCode::invalid_argument, "large is -1");
}

TEST(Angles, FindFacesBetweenSharpEdgesAndJoinTangentOnes) {
  const auto count = [](const char* name, const ReconstructionOptions& options) {
    return find_regions(geometry::mended(test::triangulated(made_brep(name), 1e-3, 12).mesh, 0).mesh, options)
        .regions.size();
  };
  EXPECT_EQ(count("drilled", {.method = RegionMethod::angles}), 7u);
  // The round goes over into both of its neighbours.
  EXPECT_EQ(count("round_edge", {.method = RegionMethod::angles}), 5u);
  EXPECT_EQ(count("round_edge", {}), 7u);
  // Strips of the bore come apart at a cutoff below their angle, and together again where they are too small.
  EXPECT_GT(count("drilled", {.method = RegionMethod::angles, .cutoff = Angle::degrees(5)}), 20u);
  EXPECT_LT(count("drilled",
                  {.method = RegionMethod::angles, .cutoff = Angle::degrees(5), .large = 0, .small = 0.5}),
            20u);
}

}  // namespace
}  // namespace isopatch::segmentation
