#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/temporary_folder.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"

#include "geometry/brep/tests/step_assembly.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using test::block;
using test::StepAssembly;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Polyhedron moved(Polyhedron polyhedron, double x, double y = 0, double z = 0) {
  polyhedron.vertices.colwise() += Eigen::Vector3d(x, y, z);
  return polyhedron;
}

class CadFile : public testing::Test {
 protected:
  fs::path file(const std::string& name, const std::string& text) const {
    write_file(folder_ / name, text);
    return folder_ / name;
  }
  BrepSet read(const StepAssembly& step, const ReadBrepOptions& options = {}) const {
    return read_breps(file("part.step", step.text()), options);
  }
  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

std::vector<std::string> names(const BrepSet& set) {
  std::vector<std::string> result;
  for (const BrepFile& body : set.bodies) result.push_back(body.name);
  return result;
}

std::vector<double> volumes(const BrepSet& set) {
  std::vector<double> result;
  for (const BrepFile& body : set.bodies) result.push_back(std::round(1e9 * body.brep.volume() * 1e6) / 1e6);
  return result;
}

TEST_F(CadFile, AClosedShellBesideASolidIsABody) {
  StepAssembly step;
  const int solid = step.body(block(1, 2, 3)).item,
            shell = step.body(moved(block(2, 2, 2), 5), "", "shell").item;
  step.product("part", {solid, shell});
  const BrepSet set = read(step);
  EXPECT_THAT(volumes(set), ElementsAre(6, 8));
  EXPECT_THAT(set.warnings, IsEmpty());
  EXPECT_EQ(set.unit, "mm");
}

TEST_F(CadFile, TwoBlocksInOneShellAreTwoBodiesAndACavityIsNone) {
  StepAssembly apart;
  apart.product("part", {apart.body({block(1, 1, 1), moved(block(2, 1, 1), 3)}).item});
  EXPECT_THAT(volumes(read(apart)), ElementsAre(1, 2));
  // The inner one's faces are listed as a body's, so that only their place shows that they bound a cavity.
  StepAssembly hollow;
  hollow.product("part", {hollow.body({block(4, 4, 4), moved(block(1, 1, 1), 1, 1, 1)}).item});
  const BrepSet set = read(hollow);
  ASSERT_THAT(volumes(set), ElementsAre(63));
  EXPECT_EQ(check(set.bodies[0].brep).boundary.shells, 2);
  StepAssembly nested;
  nested.product(
      "part",
      {nested.body({block(8, 8, 8), moved(block(6, 6, 6), 1, 1, 1), moved(block(2, 2, 2), 3, 3, 3)}).item});
  EXPECT_THAT(volumes(read(nested)), ElementsAre(512 - 216, 8));
}

TEST_F(CadFile, LooseFacesOfTouchingBlocksAreTwoBodies) {
  // IGES files of FreeCAD have nothing but the faces.
  StepAssembly loose;
  std::vector<int> faces;
  for (const Polyhedron& piece : {block(1, 1, 1), moved(block(2, 1, 1), 1), moved(block(3, 1, 1), 3)})
    for (const int face : loose.faces(piece)) faces.push_back(face);
  const int set_of_faces = loose.add("CONNECTED_FACE_SET('',(" + test::references(faces) + "))");
  loose.product("part", {loose.add("FACE_BASED_SURFACE_MODEL('',(#" + std::to_string(set_of_faces) + "))")});
  const BrepSet set = read(loose);
  EXPECT_THAT(volumes(set), testing::UnorderedElementsAre(1, 2, 3));
  for (const BrepFile& body : set.bodies) EXPECT_EQ(check(body.brep).stage, BrepStage::parameterization);
}

TEST_F(CadFile, PartsOfAnAssemblyKeepNamesAndColoursWhereverTheyArePlaced) {
  StepAssembly step;
  const StepAssembly::Body left = step.body(block(1, 1, 1)), right = step.body(block(1, 2, 1));
  step.colour(left.faces[2], {1, 0, 0});
  step.colour(right.item, {0, 0, 1});
  step.colour(right.faces[0], {0, 1, 0});
  const auto bolt = step.product("bolt", {left.item}), plate = step.product("plate", {right.item});
  const auto inner = step.product("inner", {}), whole = step.product("whole", {});
  step.place(inner, bolt, {10, 0, 0});
  step.place(inner, bolt, {20, 0, 0});
  step.place(whole, inner, {0, 5, 0});
  step.place(whole, plate, {0, 0, 0});
  const BrepSet set = read(step);
  EXPECT_THAT(names(set), ElementsAre("bolt", "bolt#1", "plate"));
  const auto colour = [&](std::size_t body, std::size_t face) {
    const auto& found = set.bodies[body].brep.faces()[face].colour;
    return found ? hex_text(*found) : "";
  };
  for (const std::size_t body : {0u, 1u})
    for (std::size_t face = 0; face < 6; ++face)
      EXPECT_EQ(colour(body, face), face == 2 ? "#ff0000" : "") << face;
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_EQ(colour(2, face), face == 0 ? "#00ff00" : "#0000ff") << face;
  EXPECT_LT((set.bodies[1].brep.box()[0] - Eigen::Vector3d(0.020, 0.005, 0)).norm(), 1e-12);
}

TEST_F(CadFile, NamesThatSayNothingAreNoneAndBytesOfWindowsAreLetters) {
  for (const char* placeholder : {"Open CASCADE STEP translator 7.6 1", "NONE", "SOLID", " "}) {
    StepAssembly step;
    step.product(placeholder, {step.body(block(1, 1, 1)).item});
    EXPECT_THAT(names(read(step)), ElementsAre("part")) << placeholder;
  }
  StepAssembly latin, utf8;
  latin.product(
      "Tr\xe4ger \xd8"
      "8",
      {latin.body(block(1, 1, 1)).item});
  utf8.product("Träger Ø8", {utf8.body(block(1, 1, 1)).item});
  EXPECT_THAT(names(read(latin)), ElementsAre("Träger Ø8"));
  EXPECT_THAT(names(read(utf8)), ElementsAre("Träger Ø8"));
}

TEST_F(CadFile, UnitsMadeOfUnitsAreHonoured) {
  const std::string metre = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))";
  StepAssembly plain(metre);
  plain.product("part", {plain.body(block(1, 2, 3)).item});
  // The seventh entity is the metre: an ell of it, and a rod of five ells.
  const std::string text = plain.text();
  std::string chained = text;
  const std::size_t at = chained.find("GLOBAL_UNIT_ASSIGNED_CONTEXT((#7");
  ASSERT_NE(at, text.npos);
  chained.replace(at, 32, "GLOBAL_UNIT_ASSIGNED_CONTEXT((#9003");
  chained.insert(chained.rfind("ENDSEC;"),
                 "#9000=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.5),#7);\n"
                 "#9001=(CONVERSION_BASED_UNIT('ELL',#9000)LENGTH_UNIT()NAMED_UNIT(*));\n"
                 "#9002=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(5.),#9001);\n"
                 "#9003=(CONVERSION_BASED_UNIT('ROD',#9002)LENGTH_UNIT()NAMED_UNIT(*));\n");
  EXPECT_NEAR(read_brep(file("m.step", text)).brep.volume(), 6, 1e-9);
  EXPECT_NEAR(read_brep(file("rod.step", chained)).brep.volume(), 6 * 2.5 * 2.5 * 2.5, 1e-9);
}

TEST_F(CadFile, AMissingUnitIsAWarningAndMayBeGiven) {
  StepAssembly step("$");
  step.product("part", {step.body(block(1, 2, 3)).item});
  const BrepSet set = read(step);
  EXPECT_THAT(volumes(set), ElementsAre(6));
  ASSERT_THAT(set.warnings, testing::Contains(HasSubstr("has no unit of length; mm is taken")));
  EXPECT_EQ(set.unit, "mm, since the file states none");
  const BrepSet given = read(step, {.length_unit = 0.0254});
  EXPECT_NEAR(given.bodies[0].brep.volume(), 6 * std::pow(0.0254, 3), 1e-12);
  EXPECT_THAT(given.warnings, IsEmpty());
  StepAssembly stated;
  stated.product("part", {stated.body(block(1, 2, 3)).item});
  EXPECT_THAT(isopatch::test::message_of([&] { read(stated, {.length_unit = 0.0254}); }),
              HasSubstr("leave length_unit out"));
}

TEST_F(CadFile, TheScaleOfAnIgesModelCounts) {
  write_brep(folder_ / "part.igs", make_brep(block(0.1, 0.2, 0.3)), {.unit = "mm"});
  std::string text = read_file(folder_ / "part.igs");
  // Parameter 13 stands before the flag and the name of the unit.
  const std::size_t at = text.find(",1.,2,2HMM");
  ASSERT_NE(at, text.npos);
  text.replace(at, 4, ",.5,");
  const BrepSet set = read_breps(file("scaled.igs", text));
  EXPECT_NEAR(set.bodies[0].brep.volume(), 8 * 0.006, 1e-9);
  EXPECT_THAT(set.warnings, testing::Contains(HasSubstr("drawn 0.5 times its size")));
}

TEST_F(CadFile, WhatCannotBeReadIsNamedOrLeftOut) {
  StepAssembly step;
  const StepAssembly::Body good = step.body(block(1, 2, 3)), bad = step.body(moved(block(1, 1, 1), 5));
  const auto first = step.product("first", {good.item}), second = step.product("second", {bad.item}),
             all = step.product("all", {});
  step.place(all, first, {0, 0, 0});
  step.place(all, second, {0, 0, 0});
  std::string text = step.text();
  // One face of the second has a surface that is nowhere.
  const std::string face = "#" + std::to_string(bad.faces[3]) + "=ADVANCED_FACE";
  const std::size_t at = text.find(face), comma = text.find("),#", at);
  text.replace(comma + 2, text.find(',', comma + 3) - comma - 2, "#99999");
  const fs::path path = file("part.step", text);
  EXPECT_THAT(isopatch::test::message_of([&] { read_breps(path); }),
              testing::AllOf(HasSubstr("bad_format: "), HasSubstr("part.step: not all of the file"),
                             HasSubstr("ADVANCED_FACE refers to #99999"), HasSubstr("--allow-partial")));
  const BrepSet partial = read_breps(path, {.allow_partial = true});
  EXPECT_THAT(names(partial), ElementsAre("first"));
  EXPECT_THAT(partial.warnings, testing::Contains(HasSubstr("of 'second': could not be made")));
  EXPECT_THAT(partial.warnings, testing::Contains(HasSubstr("body 'second': the boundary is open")));
  const BrepSet shown = read_breps(path, {.sew = {.accept_open = true}});
  EXPECT_EQ(shown.bodies.size(), 2u);
  EXPECT_THAT(shown.missing, testing::Contains(HasSubstr("refers to #99999")));
}

TEST_F(CadFile, TokensAreCheckedBeforeTheLibrarySeesThem) {
  StepAssembly step;
  step.product("part", {step.body(block(1, 2, 3)).item});
  std::string text = step.text();
  const std::size_t at = text.find("(1.0000000000000000,");
  ASSERT_NE(at, text.npos);
  text.replace(at + 1, 18, "1.#IND");
  EXPECT_THAT(isopatch::test::message_of([&] { read_breps(file("bad.step", text)); }),
              HasSubstr("= CARTESIAN_POINT: '1.#IND' is no number"));
  text = step.text();
  text.replace(text.find("(1.0000000000000000,") + 1, 18, "10e-1");  // the library would take 10 and -1
  EXPECT_NEAR(read_brep(file("small.step", text)).brep.volume(), 6e-9, 1e-15);
  text = step.text();
  text.replace(text.find("(0.0000000000000000,"), 20, "(0,5,");  // a decimal comma
  EXPECT_THAT(isopatch::test::message_of([&] { read_breps(file("comma.step", text)); }),
              HasSubstr("CARTESIAN_POINT must have a name and one to three numbers"));
}

TEST_F(CadFile, AFileThatTakesTooLongOrTooMuchIsAnError) {
  StepAssembly step;
  for (int i = 0; i < 4; ++i) step.product("part", {step.body(test::prism(200)).item});
  const fs::path path = file("part.step", step.text());
  const auto limited = [&](GuardLimits limits) {
    return isopatch::test::message_of([&] { read_breps(path, {.limits = limits}); });
  };
  EXPECT_THAT(limited({.seconds = 1e-3, .bytes = 0}),
              testing::AllOf(HasSubstr("bad_format: "), HasSubstr("part.step"),
                             HasSubstr("was stopped after 0.001 s"), HasSubstr("--cad-time-limit")));
#if !defined(__SANITIZE_ADDRESS__)
  EXPECT_THAT(
      limited({.seconds = 100, .bytes = 50'000'000}),
      testing::AllOf(HasSubstr("bad_format: "), HasSubstr("the CAD library could not read the file"),
                     HasSubstr("it needed more than 0.05 GB"), HasSubstr("a higher --cad-memory-limit")));
  EXPECT_THAT(
      limited({.seconds = 100, .bytes = 49'999'999}),
      HasSubstr("part.step: the memory limit for CAD files is 49999999 bytes; it must be 50000000 or more"));
#endif
  EXPECT_EQ(read_breps(path).bodies.size(), 4u);
}

TEST_F(CadFile, BodiesComeBackBitForBitAndPhasesAreHeard) {
  const Brep brep = make_brep(test::l_shape());
  write_brep(folder_ / "part.brep", brep, {.unit = "m"});
  std::vector<std::string> phases;
  ReadBrepOptions options;
  options.progress.report = [&](std::string_view phase, double) { phases.emplace_back(phase); };
  const BrepSet set = read_breps(folder_ / "part.brep", options);
  EXPECT_EQ(set.bodies[0].brep.vertices().cols(), brep.vertices().cols());
  for (const auto& vertex : set.bodies[0].brep.vertices().colwise()) {
    bool found = false;
    for (const auto& other : brep.vertices().colwise()) found = found || vertex == other;
    EXPECT_TRUE(found);
  }
  EXPECT_THAT(phases, testing::IsSupersetOf({"reading", "checking the bodies"}));
  EXPECT_THAT(set.warnings, testing::Contains(HasSubstr("do not state their unit of length; m is taken")));
}

TEST_F(CadFile, OtherEndingsAreReadToo) {
  StepAssembly step;
  step.product("part", {step.body(block(1, 2, 3)).item});
  EXPECT_EQ(read_breps(file("a.p21", step.text())).bodies.size(), 1u);
  write_brep(folder_ / "b.brep", make_brep(block(1, 2, 3)), {.unit = "m"});
  fs::copy(folder_ / "b.brep", folder_ / "b.brp");
  EXPECT_NEAR(read_brep(folder_ / "b.brp").brep.volume(), 6, 1e-9);
}

}  // namespace
}  // namespace isopatch::geometry
