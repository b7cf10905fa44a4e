#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/altered_kernel.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/measures.hpp"
#include "geometry/topology/tests/sample_solids.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/internal/best_face_map.hpp"
#include "segmentation/parameterization/internal/hex_complex.hpp"
#include "segmentation/parameterization/internal/mean_value_map.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/sample_solids.hpp"
#include "segmentation/parameterization/tests/spline_blocks.hpp"

namespace isopatch::segmentation {
namespace {

using test::ThrowsError;

Parameterization patch_of(const geometry::BrepFile& solid, const ParameterizationOptions& options = {}) {
  return parameterize(hex_model({solid}), options);
}

void expect_usable(const Parameterization& made) {
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_GT(test::smallest_determinant(made.patches.patches[0], 9), 0);
}

TEST(Solids, AQuarterTubeKeepsItsVolume) {
  const Parameterization made = patch_of(test::quarter_tube());
  expect_usable(made);
  EXPECT_GT(made.report.patches[0].quality.min_scaled_jacobian, 0.99);
  const double volume = std::numbers::pi / 4 * 3 * 1.5;
  // Area about 15 times the largest deviation.
  EXPECT_NEAR(made.report.patches[0].volume, volume, 15 * made.report.tolerance);
}

TEST(Solids, ATwistedBarIsCertified) {
  const Parameterization made = patch_of(test::twisted_bar());
  expect_usable(made);
  EXPECT_NEAR(made.report.patches[0].volume, 4, 18 * made.report.tolerance);
}

TEST(Solids, ADoublyCurvedFaceIsFittedToTheTolerance) {
  const Parameterization made = patch_of(test::hilly_cube());
  expect_usable(made);
  const double hill = 0.3 * 4 / std::pow(std::numbers::pi, 2);
  EXPECT_NEAR(made.report.patches[0].volume, 1 + hill, 6 * made.report.tolerance);
}

TEST(Solids, ATrimmedFaceWhoseBlendFoldsTakesTheMeanValueMap) {
  const Hexahedron block = hexahedra(hex_model({test::trimmed_slab()})).front();
  int folded = 0;
  for (const QuadFace& face : block.faces) {
    if (smallest_sine(FaceMap(face)) >= 0) continue;
    ++folded;
    const FaceMap map = best_face_map(face);
    EXPECT_EQ(map.kind(), FaceMapKind::mean_value);
    EXPECT_GT(smallest_sine(map), 0);
    // The triangles that it stands on fill the face and lose nothing.
    const std::optional<DomainMesh> mesh = face.mesh();
    ASSERT_TRUE(mesh.has_value());
    const MeanValueMap plain(FaceMap(face), *mesh);
    // Flat triangles at the outline may come out as nothing, but for round-off.
    EXPECT_GT(plain.smallest_area(), -1e-15);
  }
  EXPECT_EQ(folded, 2);
}

/// A fan around a point that lies on the outline's number `at`: one of its edges has no length.
DomainMesh fan_from_outline(DomainMesh mesh, std::size_t at) {
  const auto count = static_cast<int>(mesh.outline.size());
  mesh.points.resize(mesh.outline.size());
  mesh.points.push_back(mesh.points[at]);
  mesh.triangles.clear();
  for (int i = 0; i < count; ++i) mesh.triangles.push_back({i, (i + 1) % count, count});
  return mesh;
}

TEST(Solids, AFaceKeepsItsBlendWhereTheMeanValueMapIsSingular) {
  Hexahedron block = hexahedra(hex_model({test::trimmed_slab()})).front();
  const auto folded = std::find_if(block.faces.begin(), block.faces.end(),
                                   [](const QuadFace& face) { return smallest_sine(FaceMap(face)) < 0; });
  ASSERT_NE(folded, block.faces.end());
  const DomainMesh mesh = fan_from_outline(*folded->mesh(), 1);
  ASSERT_THAT([&] { MeanValueMap(FaceMap(*folded), mesh); },
              ThrowsError(ErrorCode::singular_system, {"singular"}));
  folded->mesh = [&] { return std::optional(mesh); };
  EXPECT_EQ(best_face_map(*folded).kind(), FaceMapKind::coons);
}

void expect_exact(const std::filesystem::path& path) {
  BlockFiles files;
  files.files = {path};
  const Parameterization made = parameterize(read_blocks(files).model);
  expect_usable(made);
  EXPECT_LT(made.report.worst_face().deviation, 1e-12 * made.report.size);
  EXPECT_NEAR(made.report.patches[0].volume, geometry::read_brep(path).brep.volume(),
              1e-9 * std::pow(made.report.size, 3));
}

TEST(Solids, PolyhedraAndStepFilesComeOutExactly) {
  expect_exact(geometry::test::made_solid("block"));
  const auto folder = std::filesystem::path(testing::TempDir()) / "isopatch_exact_solids";
  std::filesystem::create_directories(folder);
  const geometry::Brep block = geometry::read_brep(geometry::test::made_solid("block")).brep;
  for (const char* ending : {"step", "iges", "brep", "xml", "off"}) {
    SCOPED_TRACE(ending);
    geometry::write_brep(folder / (std::string("block.") + ending), block);
    expect_exact(folder / (std::string("block.") + ending));
  }
  std::filesystem::remove_all(folder);
}

TEST(Solids, PolyhedraAndStepFilesOfOthersComeOutExactly) {
  for (const char* file : {"models/block.step", "models/wedge_ok.step", "solids/ffoCube.xml"}) {
    SCOPED_TRACE(file);
    const auto path = isopatch::test::data_file(file);
    ISOPATCH_NEEDS(path);
    expect_exact(path);
  }
}

// Its top has a corner of more than 180 degrees: any smooth map of a square to it folds there.
TEST(Solids, ACornerThatNoPatchHasIsReportedWithItsPlace) {
  const Parameterization made = patch_of(test::straight(
      "deformed cube",
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.2, .125, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {.125, .5, 1}}}));
  EXPECT_FALSE(made.report.certified());
  ASSERT_TRUE(made.report.patches[0].folded_edge.has_value());
  EXPECT_LT((made.report.patches[0].folded_edge->place - Eigen::Vector3d(.125, .5, 1)).norm(), 1e-9);
  EXPECT_THAT(made.report.complaints()[0], testing::AllOf(testing::HasSubstr("'deformed cube' is folded"),
                                                          testing::HasSubstr("edge at (0.125, 0.5, 1)"),
                                                          testing::HasSubstr("180 degrees")));
}

TEST(Solids, ThatWindComeOutRightHandedEitherWay) {
  const auto line = geometry::KnotVector();
  for (const bool mirrored : {false, true}) {
    const geometry::NurbsVolume spring =
        test::bent({geometry::KnotVector::uniform(3, 96), line, line}, [=](const Eigen::Vector3d& p) {
          return test::helix(mirrored ? Eigen::Vector3d(p[0], 1 - p[1], p[2]) : p, 6);
        });
    const Parameterization made = patch_of(test::solid_of("spring", spring), {.fit = {.max_spans = 256}});
    expect_usable(made);
    EXPECT_NEAR(made.report.patches[0].volume, std::abs(geometry::volume(spring)), 0.01);
  }
}

// With eight turns all samples of a single span lie at one angle: that must not pass for a straight line. Its
// degree is too high for its knots to be kept.
TEST(Solids, TurnsAreNotMissedBetweenSamples) {
  const auto line = geometry::KnotVector();
  const geometry::NurbsVolume spring = test::bent({geometry::KnotVector::uniform(5, 128), line, line},
                                                  [](const Eigen::Vector3d& p) { return test::helix(p, 8); });
  const Parameterization made = patch_of(test::solid_of("spring", spring), {.fit = {.tolerance = 1e-2}});
  EXPECT_NEAR(made.report.patches[0].volume, std::abs(geometry::volume(spring)), 0.05);
}

TEST(Solids, OfNoVolumeAreRefused) {
  const geometry::BrepFile sound = test::brick("sheet", {0, 0, 0}, {1, 1, 1});
  const geometry::Brep flat =
      geometry::test::altered(sound.brep, [](auto& altered) { altered.volume_factor = 1e-14; });
  EXPECT_THAT(
      [&] {
        hex_model({{flat, "sheet"}});
      },
      ThrowsError(ErrorCode::invalid_argument, {"'sheet'", "no volume"}));
}

/// A cube, the surface of one of its faces `off` beside its edges.
geometry::BrepFile lid_off_its_edges(double off) {
  const geometry::Brep sound = geometry::make_brep(geometry::test::block(1, 1, 1));
  const FaceId top(5);
  const Eigen::Vector3d out = sound.outward_normal(top, {0.5, 0.5});
  return {geometry::test::altered(sound,
                                  [&](auto& altered) {
                                    altered.moved_face = top;
                                    altered.face_moved_by = off * out;
                                  }),
          "box"};
}

TEST(Solids, ASurfaceOffItsOwnEdgesIsADeviation) {
  const Parameterization made = patch_of(lid_off_its_edges(0.05));
  EXPECT_FALSE(made.report.usable());
  EXPECT_NEAR(made.report.worst_face().deviation, 0.05, 1e-9);
  EXPECT_NEAR(made.report.worst_face().off_edges, 0.05, 1e-9);
  EXPECT_THAT(made.report.complaints()[0], testing::HasSubstr("off its own edges"));
  // What sewing has closed is known before.
  geometry::BrepFile sewn = lid_off_its_edges(0.001);
  sewn.largest_correction = 0.001;
  EXPECT_LT(patch_of(sewn).report.worst_face().deviation, 1e-9);
  expect_usable(patch_of(lid_off_its_edges(0)));
}

TEST(Solids, ComplaintsNameTheOptionsThatHelp) {
  ParameterizationOptions options;
  options.fit = {.tolerance = 1e-7, .max_spans = 4};
  options.names = {"--max-spans", "--tolerance"};
  const Parameterization made = patch_of(test::hilly_cube(), options);
  ASSERT_FALSE(made.report.complaints().empty());
  EXPECT_THAT(made.report.complaints()[0],
              testing::AllOf(testing::HasSubstr("raise --max-spans above 4, or --tolerance to ")));
  // The tolerance that it names is enough.
  options.fit.tolerance = 2 * made.report.worst_face().deviation / made.report.size;
  EXPECT_TRUE(patch_of(test::hilly_cube(), options).report.complaints().empty());
}

TEST(Solids, OptionsOutOfRangeAreNamed) {
  ParameterizationOptions options;
  options.fit.tolerance = 1;
  EXPECT_THAT([&] { patch_of(test::quarter_tube(), options); },
              ThrowsError(ErrorCode::invalid_argument, {"tolerance is 1"}));
  options = {};
  options.wanted_quality = 1;
  EXPECT_THAT([&] { patch_of(test::quarter_tube(), options); },
              ThrowsError(ErrorCode::invalid_argument, {"wanted_quality is 1"}));
}

TEST(BadSolids, AnOpenShellNamesTheEdge) {
  geometry::Polyhedron open = geometry::test::block(1, 1, 1);
  open.faces.pop_back();
  const geometry::Brep shell = geometry::make_brep(open, {.accept_open = true});
  EXPECT_THAT(
      [&] {
        hex_model({{shell, "part"}});
      },
      ThrowsError(ErrorCode::not_conforming, {"'part'", "vertices ", "shell is open, only face "}));
}

TEST(BadSolids, ANonManifoldEdgeNamesItsFaces) {
  geometry::Polyhedron wall = geometry::test::block(1, 1, 1);
  wall.faces.push_back({0, 1, 7, 6});
  const geometry::Brep shell = geometry::make_brep(wall, {.accept_open = true});
  EXPECT_THAT(
      [&] {
        hex_model({{shell, "part"}});
      },
      ThrowsError(ErrorCode::not_conforming, {"'part'", "3 faces meet here", "face 6", "vertices 0"}));
}

TEST(BadSolids, AFiveCorneredFaceIsNamed) {
  EXPECT_THAT(
      [] {
        hex_model({{geometry::make_brep(geometry::test::prism(5)), "part"}});
      },
      ThrowsError(ErrorCode::unsupported, {"'part', face 5 has 5 corners", "four", "Cut the solid"}));
}

TEST(BadSolids, AnEdgeOfNoLengthIsNamed) {
  const geometry::BrepFile sound = test::brick("part", {0, 0, 0}, {1, 1, 1});
  const geometry::Brep brep =
      geometry::test::altered(sound.brep, [](auto& altered) { altered.tables.edges[3].length = 1e-12; });
  EXPECT_THAT(
      [&] {
        hex_model({{brep, "part"}});
      },
      ThrowsError(ErrorCode::invalid_argument, {"'part'", "vertices", "no length"}));
}

TEST(BadSolids, ASelfIntersectingFaceIsNamedWithThePlace) {
  // The southern outline bulges over the northern one.
  const auto knots = geometry::KnotVector::uniform(3, 12);
  const auto line = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return test::outline_curve(geometry::KnotVector(),
                               [=](double t) -> Eigen::Vector2d { return (1 - t) * from + t * to; });
  };
  const geometry::Brep bulging = test::slab_between(
      test::outline_curve(knots,
                          [](double s) { return Eigen::Vector2d(s, 0.7 * std::sin(std::numbers::pi * s)); }),
      line({0, 0.5}, {1, 0.5}), line({0, 0}, {0, 0.5}), line({1, 0}, {1, 0.5}), 1);
  EXPECT_THAT(
      [&] {
        hex_model({{bulging, "part"}});
      },
      ThrowsError(ErrorCode::invalid_argument, {"'part', face 0", "crosses itself at ("}));
}

TEST(BadSolids, AnotherGraphThanACubesIsRefused) {
  // Two cubes, one on the other, in one.
  geometry::Polyhedron tower;
  tower.vertices.resize(3, 12);
  for (int i = 0; i < 12; ++i) tower.vertices.col(i) << (i & 1), (i >> 1 & 1), i / 4;
  tower.faces = {{0, 2, 3, 1}, {8, 9, 11, 10}};
  for (const int low : {0, 4})
    for (const std::array<int, 2>& side : {std::array{0, 1}, {1, 3}, {3, 2}, {2, 0}})
      tower.faces.push_back({low + side[0], low + side[1], low + side[1] + 4, low + side[0] + 4});
  EXPECT_THAT(
      [&] {
        hex_model({{geometry::make_brep(tower), "tower"}});
      },
      ThrowsError(ErrorCode::unsupported,
                  {"'tower' is no topological hexahedron", "12 vertices, 20 edges and 10 faces"}));
}

HexModel large_and_small() {
  return hex_model({test::brick("large", {0, 0, 0}, {1, 2, 1}), test::brick("small", {1, 0, 0}, {1, 1, 1})});
}

TEST(TJoints, AreRefusedByName) {
  const HexModel model = large_and_small();
  ASSERT_EQ(model.topology.t_joints.size(), 1u);
  EXPECT_THAT([&] { parameterize(model); },
              ThrowsError(ErrorCode::unsupported, {"small:face ", "only a part of face large:face "}));
}

TEST(TJoints, SayWhereThePartLiesAndWhichEdgesItDivides) {
  const HexModel model = large_and_small();
  geometry::validate(model.topology);
  ASSERT_EQ(model.topology.t_joints.size(), 1u);
  const geometry::TJoint& joint = model.topology.t_joints[0];
  EXPECT_EQ(joint.whole.block, geometry::BlockId(0));
  ASSERT_EQ(joint.parts.size(), 1u);
  EXPECT_EQ(joint.parts[0].side.block, geometry::BlockId(1));
  ASSERT_TRUE(joint.parts[0].rectangle.has_value());
  const geometry::SideRectangle& half = *joint.parts[0].rectangle;
  EXPECT_NEAR((half.high[0] - half.low[0]) * (half.high[1] - half.low[1]), 0.5, 1e-6);
  // One edge and the vertices at its ends are common; two edges are divided in their middles.
  EXPECT_EQ(model.topology.vertex_count, 14);
  EXPECT_EQ(model.topology.edges.size(), 23u);
  ASSERT_EQ(model.topology.split_edges.size(), 2u);
  for (const geometry::SplitEdge& split : model.topology.split_edges) {
    ASSERT_EQ(split.at.size(), 1u);
    EXPECT_NEAR(split.at[0].share, 0.5, 1e-6);
  }
}

TEST(TJoints, MayHaveSeveralParts) {
  const HexModel model =
      hex_model({test::brick("large", {0, 0, 0}, {1, 2, 1}), test::brick("first", {1, 0, 0}, {1, 0.5, 1}),
                 test::brick("second", {1, 0.5, 0}, {1, 1.5, 1})});
  ASSERT_EQ(model.topology.t_joints.size(), 1u);
  EXPECT_EQ(model.topology.t_joints[0].parts.size(), 2u);
  // What the two have in common divides the large one's edges once.
  EXPECT_EQ(model.topology.vertex_count, 16);
  ASSERT_EQ(model.topology.split_edges.size(), 2u);
  for (const geometry::SplitEdge& split : model.topology.split_edges) {
    ASSERT_EQ(split.at.size(), 1u);
    EXPECT_NEAR(std::abs(split.at[0].share - 0.5), 0.25, 1e-6);
  }
}

}  // namespace
}  // namespace isopatch::segmentation
