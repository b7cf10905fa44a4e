#include "geometry/brep/read_brep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/data_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/io/read_off.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using isopatch::test::data_file;
using testing::AllOf;
using testing::HasSubstr;

/// A folder that goes with the test.
class ReadBrep : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("isopatch_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path file(const std::string& name) const { return folder_ / name; }
  fs::path folder_;
};

TEST_F(ReadBrep, EveryFormatKeepsAnLShapedSolidInEveryUnit) {
  const Brep brep = make_brep(test::l_shape());
  for (const std::string ending : {"step", "stp", "iges", "igs", "brep", "xml", "off"})
    for (const auto& [unit, metres] : {std::pair("mm", 1e-3), std::pair("m", 1.0), std::pair("in", 0.0254)}) {
      SCOPED_TRACE(ending + " in " + unit);
      const fs::path path = file("solid." + ending);
      write_brep(path, brep, {.unit = unit});
      ReadBrepOptions options;
      if (ending == "brep" || ending == "xml" || ending == "off") options.length_unit = metres;
      const BrepFile again = read_brep(path, options);
      EXPECT_EQ(again.brep.faces().size(), 8u);
      EXPECT_EQ(again.brep.edges().size(), 18u);
      EXPECT_EQ(again.brep.vertices().cols(), 12);
      EXPECT_NEAR(again.brep.volume(), 3, 1e-9);
      EXPECT_NEAR(again.brep.area(), 14, 1e-9);
      EXPECT_EQ(check(again.brep).count(Convexity::non_convex), 1);
    }
}

TEST_F(ReadBrep, NamesAndColoursOfStepFacesSurvive) {
  // A hand-written colour and name come in through a first file, so that the second shows what reading kept.
  std::string text = read_file(test::made_solid("block"));
  int named = 0;
  for (std::size_t at = 0; (at = text.find("ADVANCED_FACE(", at)) != text.npos; ++at) {
    const std::size_t open = text.find('\'', at), close = text.find('\'', open + 1);
    text.replace(open + 1, close - open - 1, "side " + std::to_string(named++));
  }
  ASSERT_EQ(named, 6);
  write_file(file("named.step"), text);
  const Brep first = read_brep(file("named.step")).brep;
  std::vector<std::string> names;
  for (const BrepFace& face : first.faces()) names.push_back(face.name);
  EXPECT_THAT(names,
              testing::UnorderedElementsAre("side 0", "side 1", "side 2", "side 3", "side 4", "side 5"));
  write_brep(file("again.step"), first);
  const Brep second = read_brep(file("again.step")).brep;
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_EQ(second.faces()[f].name, names[f]);
    EXPECT_EQ(second.faces()[f].colour.has_value(), first.faces()[f].colour.has_value());
  }
}

TEST_F(ReadBrep, ColoursOfFacesComeBackToTheLastDigitOfAByte) {
  // As STEP says it: a styled item for each of two faces.
  std::string text = read_file(test::made_solid("block"));
  std::vector<std::string> faces;
  for (std::size_t at = 0; (at = text.find(" = ADVANCED_FACE(", at)) != text.npos; ++at)
    faces.push_back(text.substr(text.rfind('#', at), at - text.rfind('#', at)));
  ASSERT_EQ(faces.size(), 6u);
  std::string styles;
  std::string items;
  int id = 900000;
  for (int i = 0; i < 2; ++i) {
    const std::string colour = i == 0 ? "0.2,0.4,0.6" : "1.,0.,0.5";
    styles += "#" + std::to_string(id) + "=COLOUR_RGB(''," + colour + ");\n";
    styles += "#" + std::to_string(id + 1) + "=FILL_AREA_STYLE_COLOUR('',#" + std::to_string(id) + ");\n";
    styles += "#" + std::to_string(id + 2) + "=FILL_AREA_STYLE('',(#" + std::to_string(id + 1) + "));\n";
    styles += "#" + std::to_string(id + 3) + "=SURFACE_STYLE_FILL_AREA(#" + std::to_string(id + 2) + ");\n";
    styles += "#" + std::to_string(id + 4) + "=SURFACE_SIDE_STYLE('',(#" + std::to_string(id + 3) + "));\n";
    styles +=
        "#" + std::to_string(id + 5) + "=SURFACE_STYLE_USAGE(.BOTH.,#" + std::to_string(id + 4) + ");\n";
    styles +=
        "#" + std::to_string(id + 6) + "=PRESENTATION_STYLE_ASSIGNMENT((#" + std::to_string(id + 5) + "));\n";
    styles += "#" + std::to_string(id + 7) + "=STYLED_ITEM('',(#" + std::to_string(id + 6) + ")," +
              faces[static_cast<std::size_t>(i)] + ");\n";
    id += 8;
  }
  const std::size_t end = text.rfind("ENDSEC;");
  text.insert(end, styles);
  write_file(file("coloured.step"), text);
  const Brep first = read_brep(file("coloured.step")).brep;
  write_brep(file("again.step"), first);
  const Brep second = read_brep(file("again.step")).brep;
  int found = 0;
  for (const Brep& brep : {first, second})
    for (const BrepFace& face : brep.faces())
      for (const Colour& wanted : {Colour{0.2, 0.4, 0.6}, Colour{1, 0, 0.5}})
        if (face.colour && std::abs((*face.colour)[0] - wanted[0]) < 0.002 &&
            std::abs((*face.colour)[1] - wanted[1]) < 0.002 &&
            std::abs((*face.colour)[2] - wanted[2]) < 0.002)
          ++found;
  EXPECT_EQ(found, 4);
}

TEST_F(ReadBrep, NamesAndColoursOfBodiesAndFacesAreThoseOfAnotherProgram) {
  const BrepSet set = read_breps(test::made_solid("named"));
  ASSERT_EQ(set.bodies.size(), 2u);
  EXPECT_EQ(set.bodies[0].name, "plate");
  EXPECT_EQ(set.bodies[1].name, "pin");
  std::map<std::string, int> plate, pin;
  for (const BrepFace& face : set.bodies[0].brep.faces()) ++plate[face.colour ? hex_text(*face.colour) : ""];
  for (const BrepFace& face : set.bodies[1].brep.faces()) ++pin[face.colour ? hex_text(*face.colour) : ""];
  EXPECT_EQ(plate, (std::map<std::string, int>{{"#808080", 5}, {"#ff0066", 1}}));
  EXPECT_EQ(pin, (std::map<std::string, int>{{"#336699", 3}}));
}

// Sewn from surfaces that lie beside each other, and through a file of such.
void expect_round_trip(const Brep& brep, const fs::path& folder) {
  const SewnBrep sewn = sew(trimmed_surfaces(brep));
  EXPECT_LT(sewn.largest_correction, 1e-6 * brep.size());
  write_brep(folder / "round.xml", brep, {.unit = "m"});
  for (const Brep& again : {sewn.brep, read_brep(folder / "round.xml").brep}) {
    EXPECT_EQ(again.edges().size(), brep.edges().size());
    EXPECT_EQ(again.vertices().cols(), brep.vertices().cols());
    EXPECT_NEAR(again.volume(), brep.volume(), 1e-7 * brep.volume());
    for (std::size_t f = 0; f < brep.faces().size(); ++f)
      EXPECT_NEAR(again.area(FaceId(static_cast<int>(f))), brep.area(FaceId(static_cast<int>(f))),
                  1e-6 * brep.area(FaceId(static_cast<int>(f))));
  }
  EXPECT_THAT(isopatch::test::message_of([&] { write_brep(folder / "round.off", brep); }),
              HasSubstr("is no straight line"));
}

TEST_F(ReadBrep, RoundSolidsBecomeTrimmedSurfacesAndComeBack) {
  for (const char* name : {"grooved", "round_edge"}) {
    SCOPED_TRACE(name);
    expect_round_trip(test::made_brep(name), folder_);
  }
}

// A pole is a side of the surface's domain, and a curve of no length in space.
TEST_F(ReadBrep, PolesOfSpheresCannotBeSewnYet) {
  EXPECT_ERROR(sew(trimmed_surfaces(test::made_brep("round_corner"))), ErrorCode::not_manifold,
               "from (0.003, 0.003, 0.01) to (0.003, 0.003, 0.01) m, has no length");
}

TEST_F(ReadBrep, RoundSolidsOfOthersBecomeTrimmedSurfacesAndComeBack) {
  for (const char* name : {"block_fillet1.step", "three_concave_edge.step", "block_torus_fillet3.step"}) {
    SCOPED_TRACE(name);
    const auto path = data_file(std::string("models/") + name);
    ISOPATCH_NEEDS(path);
    expect_round_trip(read_brep(path).brep, folder_);
  }
}

// The faces of a solid, one of which lies `off` away from its neighbours, as a share of the solid's size.
std::vector<TrimmedSurface> faces_with_one_off(const Brep& brep, double off) {
  std::vector<TrimmedSurface> faces = trimmed_surfaces(brep);
  NurbsSurface& surface = faces[0].surface;
  const Parameter<2> middle = 0.5 * (surface.low() + surface.high());
  const Eigen::Vector3d normal =
      surface.jacobian(middle).col(0).cross(surface.jacobian(middle).col(1)).normalized();
  surface = NurbsSurface(surface.knots(), surface.control_points().colwise() + off * brep.size() * normal,
                         surface.weights());
  return faces;
}

TEST_F(ReadBrep, SmallGapsBetweenRoundFacesAreSewnAndTold) {
  for (const char* name : {"grooved", "round_edge"}) {
    SCOPED_TRACE(name);
    const Brep brep = test::made_brep(name);
    const double off = 3e-5;
    const SewnBrep sewn = sew(faces_with_one_off(brep, off));
    EXPECT_NEAR(sewn.largest_correction, off * brep.size(), 0.7 * off * brep.size());
    EXPECT_EQ(sewn.brep.edges().size(), brep.edges().size());
    EXPECT_NEAR(sewn.brep.volume(), brep.volume(), off * brep.size() * brep.area());
    EXPECT_TRUE(check(sewn.brep).boundary.bounds_a_solid());
  }
}

TEST_F(ReadBrep, WideGapsBetweenRoundFacesAreRefusedWithTheirPlace) {
  for (const char* name : {"grooved", "round_edge"}) {
    const Brep brep = test::made_brep(name);
    EXPECT_ERROR(sew(faces_with_one_off(brep, 2e-2)), ErrorCode::not_manifold, "belongs to one face only")
        << name;
  }
}

TEST_F(ReadBrep, PolyhedraComeFromOffFiles) {
  const Polyhedron prism = test::prism(5);
  write_file(file("prism.off"), to_off(prism));
  const BrepFile read = read_brep(file("prism.off"), {.length_unit = 0.1});
  EXPECT_NEAR(read.brep.volume(), 1e-3 * test::polyhedron_volume(prism), 1e-15);
}

TEST_F(ReadBrep, TheChairStandsNineSolidsAreSewn) {
  struct Part {
    const char* name;
    double correction;  // at most; what the published faces leave open along their edges
  };
  double sum = 0;
  for (const Part& part : {Part{"1_seed002_3", 1.2e-3}, Part{"1_seed002_4", 1e-5}, Part{"1_seed002_5", 2e-5},
                           Part{"2", 4e-4}, Part{"3", 1.2e-3}, Part{"4_seed005_3", 6e-4},
                           Part{"4_seed005_4", 1e-5}, Part{"4_seed005_5", 1e-5}, Part{"5", 1e-6}}) {
    SCOPED_TRACE(part.name);
    const auto path =
        data_file(std::string("chair_stand/solids/segmented_objStandFiveParts") + part.name + ".xml");
    ISOPATCH_NEEDS(path);
    const BrepFile read = read_brep(path);
    const BrepReport report = check(read.brep);
    EXPECT_EQ(report.stage, BrepStage::parameterization);
    EXPECT_EQ(report.count(Convexity::convex), 12);
    EXPECT_LT(read.largest_correction, part.correction);
    EXPECT_GT(read.largest_correction, part.correction / 10);
    EXPECT_LT(report.largest_gap, part.correction);
    sum += report.volume;
  }
  EXPECT_NEAR(sum, 0.0500, 5e-4);
}

/// What is known of the polyhedra of the segmentation papers.
struct PaperSolid {
  const char* file;
  int vertices;
  std::size_t edges, faces;
  int non_convex, flat;
  BrepStage stage;
};

TEST_F(ReadBrep, SolidsOfThePapersAreWhatIsKnownOfThem) {
  for (const PaperSolid& known :
       {PaperSolid{"ffoCube.xml", 8, 12, 6, 0, 0, BrepStage::parameterization},
        PaperSolid{"ffoCube_autoSurf.xml", 8, 12, 6, 0, 0, BrepStage::parameterization},
        PaperSolid{"ffoTriBiPyramid.xml", 5, 9, 6, 0, 0, BrepStage::decomposition},
        PaperSolid{"ffoTriDoublePyramid.xml", 5, 9, 6, 3, 0, BrepStage::decomposition},
        PaperSolid{"ffoLshapeCut.xml", 14, 21, 9, 1, 0, BrepStage::decomposition},
        PaperSolid{"ffoVaseHalfed.xml", 12, 18, 8, 3, 0, BrepStage::preprocessing},
        PaperSolid{"ffoSciencePark2.xml", 30, 51, 23, 7, 4, BrepStage::decomposition},
        PaperSolid{"house.off", 10, 15, 7, 0, 0, BrepStage::decomposition}}) {
    SCOPED_TRACE(known.file);
    const auto path = data_file(std::string("solids/") + known.file);
    ISOPATCH_NEEDS(path);
    const Brep brep = read_brep(path).brep;
    const BrepReport report = check(brep);
    EXPECT_EQ(brep.vertices().cols(), known.vertices);
    EXPECT_EQ(brep.edges().size(), known.edges);
    EXPECT_EQ(brep.faces().size(), known.faces);
    EXPECT_EQ(report.count(Convexity::non_convex), known.non_convex);
    EXPECT_EQ(report.count(Convexity::flat), known.flat);
    EXPECT_EQ(report.stage, known.stage);
    EXPECT_TRUE(report.boundary.bounds_a_solid());
  }
}

TEST_F(ReadBrep, GapsThatAreTooWideAreRefusedWithTheirPlace) {
  const auto path = data_file("solids/gsSolidSP2.xml");
  ISOPATCH_NEEDS(path);
  EXPECT_THAT(isopatch::test::message_of([&] { read_breps(path); }),
              AllOf(HasSubstr("not_manifold"), HasSubstr("gsSolidSP2.xml"),
                    HasSubstr("curve 2 of loop 0 of face 0"), HasSubstr("belongs to one face only")));
}

TEST_F(ReadBrep, WhatIsNoSolidIsRefusedWithTheFilesName) {
  const auto refusal = [&](const fs::path& path, const ReadBrepOptions& options = {}) {
    return isopatch::test::message_of([&] { read_brep(path, options); });
  };
  EXPECT_THAT(refusal(file("absent.step")), AllOf(HasSubstr("io"), HasSubstr("absent.step")));
  EXPECT_THAT(refusal(file("absent.off")), AllOf(HasSubstr("io"), HasSubstr("absent.off")));
  write_file(file("text.step"), "no STEP file");
  EXPECT_THAT(refusal(file("text.step")), AllOf(HasSubstr("bad_format"), HasSubstr("text.step")));
  write_file(file("text.igs"), "no IGES file");
  EXPECT_THAT(refusal(file("text.igs")), AllOf(HasSubstr("bad_format"), HasSubstr("text.igs")));
  write_file(file("text.brep"), "no OpenCASCADE file");
  EXPECT_THAT(refusal(file("text.brep")), AllOf(HasSubstr("bad_format"), HasSubstr("text.brep")));
  write_file(file("text.dwg"), "x");
  EXPECT_THAT(refusal(file("text.dwg")), AllOf(HasSubstr("unsupported"), HasSubstr("text.dwg")));

  Polyhedron open = test::block(1, 2, 3);
  open.faces.pop_back();
  write_file(file("open.off"), to_off(open));
  EXPECT_THAT(refusal(file("open.off")), AllOf(HasSubstr("open.off"), HasSubstr("one face only")));
  // The same through STEP: written as a shell.
  write_brep(file("open.brep"), make_brep(open, {.accept_open = true}));
  EXPECT_THAT(refusal(file("open.brep")),
              AllOf(HasSubstr("not_manifold"), HasSubstr("open.brep"),
                    HasSubstr("4 edges with one face only"), HasSubstr("of face 1")));
  EXPECT_EQ(check(read_brep(file("open.brep"), {.sew = {.accept_open = true}}).brep).stage,
            BrepStage::repair);

  write_brep(file("good.step"), make_brep(test::block(1, 2, 3)));
  EXPECT_THAT(refusal(file("good.step"), {.length_unit = 0.001}), HasSubstr("states its unit"));
  EXPECT_THAT(refusal(file("good.step"), {.sew = {.same_point = 0.5}}), HasSubstr("same_point is 0.5"));
  EXPECT_THAT(
      isopatch::test::message_of([&] { write_brep(file("good.stl"), make_brep(test::block(1, 2, 3))); }),
      HasSubstr("solids are written as .step"));
  EXPECT_THAT(isopatch::test::message_of(
                  [&] { write_brep(file("x.step"), make_brep(test::block(1, 2, 3)), {.unit = "km"}); }),
              HasSubstr("unit is 'km'"));
}

}  // namespace
}  // namespace isopatch::geometry
