#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/brep/write_brep.hpp"
#include "segmentation/parameterization/assemble_complex.hpp"
#include "segmentation/parameterization/brep_solid.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/sample_solids.hpp"
#include "segmentation/parameterization/tests/spline_blocks.hpp"

namespace isopatch::segmentation {
namespace {

using test::ThrowsError;

Parameterization patch_of(const HexSolid& solid, const ParameterizationOptions& options = {}) {
  return parameterize(hex_complex({hexahedron(solid)}), options);
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
  const Hexahedron block = hexahedron(test::trimmed_slab());
  const FaceMap blend(block.face(Side::back));
  EXPECT_LT(smallest_sine(blend), 0);
  const FaceMap map = face_map(block.face(Side::back));
  EXPECT_EQ(map.kind(), FaceMapKind::mean_value);
  EXPECT_GT(smallest_sine(map), 0);
}

void expect_exact(const std::filesystem::path& path) {
  BlockFiles files;
  files.files = {path};
  const Parameterization made = parameterize(read_blocks(files).complex);
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
  ASSERT_TRUE(made.report.patches[0].hopeless.has_value());
  EXPECT_LT((made.report.patches[0].hopeless->place - Eigen::Vector3d(.125, .5, 1)).norm(), 1e-9);
  EXPECT_THAT(made.report.complaints()[0], testing::AllOf(testing::HasSubstr("'deformed cube' is folded"),
                                                          testing::HasSubstr("edge at (0.125, 0.5, 1)"),
                                                          testing::HasSubstr("180 degrees")));
}

// Twelve cells along six turns tell nothing: the volume has to be looked at more closely.
TEST(Solids, ThatWindComeOutRightHandedEitherWay) {
  for (const bool mirrored : {false, true}) {
    const HexSolid spring = test::mapped_cube("spring", [=](const Eigen::Vector3d& p) {
      return test::helix(mirrored ? Eigen::Vector3d(p[0], 1 - p[1], p[2]) : p, 6);
    });
    const Parameterization made = patch_of(spring, {.fit = {.max_spans = 256}});
    expect_usable(made);
    // The section runs around the axis at its middle radius, 1.
    EXPECT_NEAR(made.report.patches[0].volume, 12 * std::numbers::pi * 0.04, 0.01);
  }
}

// With eight turns all samples of a single span lie at one angle: that must not pass for a straight line.
TEST(Solids, TurnsAreNotMissedBetweenSamples) {
  const HexSolid spring =
      test::mapped_cube("spring", [](const Eigen::Vector3d& p) { return test::helix(p, 8); });
  const Parameterization made = patch_of(spring, {.fit = {.tolerance = 1e-2}});
  EXPECT_NEAR(made.report.patches[0].volume, 16 * std::numbers::pi * 0.04, 0.05);
}

TEST(Solids, OfNoVolumeAreRefused) {
  EXPECT_THAT(
      [] {
        hexahedron(test::mapped_cube("sheet", [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
          return {p[0] + 0.2 * p[2], p[1] + 0.3 * p[2], 0};
        }));
      },
      ThrowsError(ErrorCode::invalid_argument, {"'sheet'", "no volume"}));
}

/// A cube that knows its edges in space, the surface of its top `off` above them.
HexSolid lid_off_its_edges(double off) {
  HexSolid solid = test::mapped_cube("box", [](const Eigen::Vector3d& p) { return p; });
  for (SolidFace& face : solid.faces)
    for (const DomainCurve& curve : face.curves)
      face.edges.push_back({[curve, surface = face.surface](double t) { return surface(curve(t)); }});
  SolidFace& top = solid.faces[static_cast<std::size_t>(Side::back)];
  top.surface = [plain = top.surface, off](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
    return plain(uv) + Eigen::Vector3d(0, 0, off);
  };
  return solid;
}

TEST(Solids, ASurfaceOffItsOwnEdgesIsADeviation) {
  const Parameterization made = patch_of(lid_off_its_edges(0.05));
  EXPECT_FALSE(made.report.usable());
  EXPECT_NEAR(made.report.worst_face().deviation, 0.05, 1e-9);
  EXPECT_NEAR(made.report.worst_face().off_edges, 0.05, 1e-9);
  EXPECT_THAT(made.report.complaints()[0], testing::HasSubstr("off its own edges"));
  // What sewing has closed is known before.
  HexSolid sewn = lid_off_its_edges(0.001);
  sewn.edge_uncertainty = 0.001;
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

/// A cube with something wrong.
HexSolid cube() {
  HexSolid solid = test::mapped_cube("part", [](const Eigen::Vector3d& p) { return p; });
  for (std::size_t f = 0; f < 6; ++f) solid.faces[f].name = "face " + std::to_string(f);
  return solid;
}

TEST(BadSolids, AnOpenShellNamesTheEdge) {
  HexSolid solid = cube();
  solid.faces.pop_back();
  EXPECT_THAT([&] { hexahedron(solid); },
              ThrowsError(ErrorCode::not_conforming,
                          {"'part'", "vertices 4 (0, 0, 1)", "shell is open", "only face 2 "}));
}

TEST(BadSolids, ANonManifoldEdgeNamesItsFaces) {
  HexSolid solid = cube();
  solid.faces.push_back(solid.faces[2]);
  solid.faces.back().name = "extra";
  EXPECT_THAT(
      [&] { hexahedron(solid); },
      ThrowsError(ErrorCode::not_conforming, {"'part'", "3 faces meet here", "'extra'", "vertices 0"}));
}

TEST(BadSolids, AFiveCorneredFaceIsNamed) {
  HexSolid solid = cube();
  solid.faces[3].corners.push_back(8);
  solid.faces[3].curves.push_back(solid.faces[3].curves[0]);
  EXPECT_THAT([&] { hexahedron(solid); },
              ThrowsError(ErrorCode::unsupported, {"'part', face 3 has 5 corners", "four", "Cut the solid"}));
}

TEST(BadSolids, AFaceWithTooFewCornersSaysWhatToDo) {
  for (const std::size_t count : {1u, 2u, 3u}) {
    HexSolid solid = cube();
    solid.faces[3].corners.resize(count);
    solid.faces[3].curves.resize(count);
    solid.faces[3].name = "lid";
    const std::string corners =
        count == 1 ? "1 corner (vertex" : std::to_string(count) + " corners (vertices";
    EXPECT_THAT([&] { hexahedron(solid); },
                ThrowsError(ErrorCode::unsupported, {"face 'lid' has " + corners, "Cut the solid"}));
  }
}

TEST(BadSolids, AnEdgeOfNoLengthIsNamed) {
  HexSolid solid = cube();
  for (auto& curve : solid.faces[4].curves) curve = [](double) -> Eigen::Vector2d { return {0.5, 0.5}; };
  EXPECT_THAT([&] { hexahedron(solid); },
              ThrowsError(ErrorCode::invalid_argument, {"face 4", "vertices 0 and 1", "no length"}));
}

TEST(BadSolids, ASelfIntersectingFaceIsNamedWithThePlace) {
  HexSolid solid = cube();
  // The outline bulges over the opposite side.
  solid.faces[5].curves[0] = [](double t) -> Eigen::Vector2d {
    return {t, 1.2 * std::sin(std::numbers::pi * t)};
  };
  EXPECT_THAT([&] { hexahedron(solid); },
              ThrowsError(ErrorCode::invalid_argument, {"face 5", "crosses itself", "1)"}));
}

TEST(BadSolids, AnotherGraphThanACubesIsRefused) {
  HexSolid prism = cube();
  // A vertex renamed in all its faces joins two of the cube's.
  for (SolidFace& face : prism.faces)
    for (int& corner : face.corners)
      if (corner == 7) corner = 0;
  EXPECT_THAT([&] { hexahedron(prism); }, ThrowsError(ErrorCode::unsupported, {"'part'"}));
}

TEST(BadSolids, APartialContactIsFoundAndRefusedByName) {
  const auto shifted = [](const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& size) {
    return hexahedron(test::mapped_cube(
        name, [=](const Eigen::Vector3d& p) -> Eigen::Vector3d { return low + size.cwiseProduct(p); }));
  };
  const HexComplex complex =
      hex_complex({shifted("large", {0, 0, 0}, {1, 2, 1}), shifted("small", {1, 0, 0}, {1, 1, 1})});
  ASSERT_EQ(complex.partial_contacts.size(), 1u);
  EXPECT_EQ(complex.label(complex.partial_contacts[0].part), "small:side west");
  EXPECT_EQ(complex.label(complex.partial_contacts[0].whole), "large:side east");
  EXPECT_THAT(
      [&] { parameterize(complex); },
      ThrowsError(ErrorCode::unsupported, {"small:side west", "only a part of face large:side east"}));
}

}  // namespace
}  // namespace isopatch::segmentation
