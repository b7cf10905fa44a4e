#include <fstream>
#include <regex>

#include "app/tests/program_fixture.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/write_brep.hpp"

namespace isopatch::app {
namespace {

/// An L of three unit squares, one thick; the edge above vertex 3 is not convex.
const std::string l_shape = R"(OFF
12 8 18
0 0 0
2 0 0
2 1 0
1 1 0
1 2 0
0 2 0
0 0 1
2 0 1
2 1 1
1 1 1
1 2 1
0 2 1
6 5 4 3 2 1 0
6 6 7 8 9 10 11
4 0 1 7 6
4 1 2 8 7
4 2 3 9 8
4 3 4 10 9
4 4 5 11 10
4 5 0 6 11
)";

class SolidFiles : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(folder_ / "l.off", l_shape);
  }
  std::string solid() const { return (folder_ / "l.off").string(); }
};

TEST_F(SolidFiles, TheCadLibraryIsNotThereBeforeTheFirstSolid) {
  const auto loaded = [] {
    std::ifstream maps("/proc/self/maps");
    const std::string text((std::istreambuf_iterator<char>(maps)), std::istreambuf_iterator<char>());
    return text.find("libTKernel") != text.npos;
  };
  if (loaded()) GTEST_SKIP() << "another test in this process has loaded it";
  EXPECT_EQ(run({"info", study()}), 0);
  EXPECT_FALSE(loaded());
  EXPECT_EQ(run({"info", solid()}), 0);
  EXPECT_TRUE(loaded());
}

TEST_F(SolidFiles, InfoSaysWhatIsReadyAndWhatIsNot) {
  ASSERT_EQ(run({"info", solid(), "--length-unit", "mm"}), 0) << err_;
  EXPECT_THAT(out_,
              HasSubstr("8 faces, 18 edges, 12 vertices: closed, manifold, oriented, one shell, genus 0, "
                        "contractible"));
  EXPECT_THAT(out_, HasSubstr("edge graph connected, simple, 3-connected"));
  EXPECT_THAT(out_, HasSubstr("17 convex, 1 non-convex; inner angles 90 to 270 degrees"));
  EXPECT_THAT(out_, HasSubstr("volume 3 mm^3, surface 14 mm^2"));
  EXPECT_THAT(out_, HasSubstr("ready for decomposition"));
  EXPECT_THAT(out_, HasSubstr("1 non-convex edge"));
}

TEST_F(SolidFiles, InfoAsJsonIsComplete) {
  ASSERT_EQ(run({"info", solid(), "--json"}), 0) << err_;
  const json solids = json::parse(out_)["solids"];
  ASSERT_EQ(solids.size(), 1u);
  const json& read = solids[0];
  EXPECT_EQ(read["stage"], "decomposition");
  EXPECT_NEAR(read["volume"].get<double>(), 3, 1e-12);
  EXPECT_NEAR(read["area"].get<double>(), 14, 1e-12);
  EXPECT_EQ(read["faces"].size(), 8u);
  EXPECT_EQ(read["edges"].size(), 18u);
  EXPECT_EQ(read["vertices"].size(), 12u);
  EXPECT_EQ(read["checks"]["three_connected"], true);
  EXPECT_EQ(read["checks"]["genus"], 0);
  int non_convex = 0;
  for (const json& edge : read["edges"]) {
    if (edge["convexity"] != "non-convex") continue;
    ++non_convex;
    EXPECT_NEAR(edge["largest_angle"].get<double>(), 270, 1e-9);
    EXPECT_EQ(edge["vertices"], json({3, 9}));
  }
  EXPECT_EQ(non_convex, 1);
}

TEST_F(SolidFiles, AnOpenBoundaryIsDescribedAndRefused) {
  std::string open = l_shape;
  open.replace(open.find("12 8 18"), 7, "12 7 18");
  open.erase(open.find("4 5 0 6 11"));
  write_file(folder_ / "open.off", open);
  EXPECT_EQ(run({"info", (folder_ / "open.off").string()}), 2);
  EXPECT_THAT(out_, HasSubstr("open, manifold, oriented, one shell"));
  EXPECT_THAT(out_, HasSubstr("ready for repair"));
  EXPECT_THAT(err_, HasSubstr("4 edges with one face only"));
  EXPECT_THAT(err_, HasSubstr("vertex 5 at (0, 2, 0) m"));
}

// Two cubes along a common edge.
TEST_F(SolidFiles, AnEdgeOfFourFacesIsCountedAsSuchAndIsNotFree) {
  write_file(folder_ / "two.off", R"(OFF
14 12 23
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
2 1 0
2 2 0
1 2 0
2 1 1
2 2 1
1 2 1
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
4 2 10 9 8
4 6 11 12 13
4 2 8 11 6
4 8 9 12 11
4 9 10 13 12
4 10 2 6 13
)");
  EXPECT_EQ(run({"info", (folder_ / "two.off").string(), "--all"}), 2);
  EXPECT_THAT(out_, HasSubstr("edges 22 convex, 1 with four faces; inner angles 90 to 90 degrees"));
  EXPECT_THAT(out_, HasSubstr(" four faces"));
  EXPECT_THAT(out_, testing::Not(HasSubstr("free")));
  EXPECT_THAT(err_, HasSubstr("of faces 3, 4, 8 and 11"));
  ASSERT_EQ(run({"info", (folder_ / "two.off").string(), "--json"}), 2);
  const json solid = json::parse(out_)["solids"][0];
  int overused = 0;
  for (const json& edge : solid["edges"]) overused += edge["convexity"] == "overused";
  EXPECT_EQ(overused, 1);
}

TEST_F(SolidFiles, TheEdgeGraphIsDrawnInThePlane) {
  const fs::path graph = folder_ / "graph.svg";
  ASSERT_EQ(run({"render", solid(), "-o", graph.string()}), 0) << err_;
  const std::string text = read_file(graph);
  const auto count = [&](const std::string& pattern) {
    const std::regex expression(pattern);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator());
  };
  EXPECT_EQ(count("<circle"), 12);
  EXPECT_EQ(count("<line class=\"curve s1\""), 17 + 1);  // the legend's sample too
  EXPECT_EQ(count("<line class=\"curve s2\""), 1 + 1);
  EXPECT_THAT(text, HasSubstr(">f7<"));
}

TEST_F(SolidFiles, PicturesShowFacesEdgesAndNumbers) {
  const fs::path picture = folder_ / "l.png";
  ASSERT_EQ(run({"render", solid(), "-o", picture.string(), "--size", "400x300"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("400 x 300 pixels, 8 faces, 18 edges, 12 vertices"));
  EXPECT_THAT(read_file(picture), StartsWith("\x89PNG"));
  EXPECT_EQ(run({"render", solid(), "-o", picture.string(), "--field", "jacobian"}), 2);
  EXPECT_THAT(err_, HasSubstr("a solid has only its faces to show"));
  EXPECT_EQ(run({"render", study(), "-o", (folder_ / "x.svg").string()}), 2);
}

/// The entities of two STEP files in one: those of the second get other numbers.
std::string both(const std::string& first, const std::string& second) {
  const auto data = [](const std::string& text) {
    const auto from = text.find("DATA;") + 5;
    return text.substr(from, text.rfind("ENDSEC;") - from);
  };
  std::string moved;
  for (const char c : data(second)) moved += c == '#' ? std::string("#7000") : std::string(1, c);
  std::string result = first;
  return result.insert(result.rfind("ENDSEC;"), moved);
}

class SeveralSolids : public SolidFiles {
 protected:
  void SetUp() override {
    SolidFiles::SetUp();
    geometry::write_brep(step("l"), geometry::read_brep(solid()).brep);
    write_file(folder_ / "box.off",
               "OFF\n8 6 12\n5 0 0\n6 0 0\n6 1 0\n5 1 0\n5 0 1\n6 0 1\n6 1 1\n5 1 1\n"
               "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    geometry::write_brep(step("box"), geometry::read_brep(folder_ / "box.off").brep);
    write_file(step("two"), both(read_file(step("l")), read_file(step("box"))));
  }
  std::string step(const std::string& name) const { return (folder_ / (name + ".step")).string(); }
};

TEST_F(SeveralSolids, AreDrawnTogetherOrOneByOne) {
  const std::string picture = (folder_ / "two.png").string();
  ASSERT_EQ(run({"render", step("two"), "-o", picture, "--size", "400x300"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("2 solids, 14 faces, 30 edges, 20 vertices"));
  EXPECT_THAT(read_file(picture), StartsWith("\x89PNG"));
  ASSERT_EQ(run({"render", step("two"), "-o", picture, "--size", "400x300", "--solid", "1"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("400 x 300 pixels, 6 faces, 12 edges, 8 vertices"));
  EXPECT_EQ(run({"render", step("two"), "-o", picture, "--solid", "2"}), 2);
  EXPECT_THAT(err_, HasSubstr("holds 2 solids, counted from 0"));
}

TEST_F(SeveralSolids, ThatAreNotWholeAreAWarningWhereThatIsAllowed) {
  std::string text = read_file(step("two"));
  const std::size_t surface = text.find("),#", text.rfind("ADVANCED_FACE")) + 3;
  text.replace(surface, text.find(',', surface) - surface, "99999");
  write_file(step("two"), text);
  EXPECT_EQ(run({"info", step("two")}), 2);
  EXPECT_THAT(err_, HasSubstr("error"));
  EXPECT_EQ(run({"info", step("two"), "--allow-partial"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("ready for repair"));
  EXPECT_THAT(err_,
              testing::AllOf(HasSubstr("warning"), HasSubstr("the boundary is open"),
                             HasSubstr("other commands leave it out"), testing::Not(HasSubstr("error"))));
}

TEST_F(SeveralSolids, AGraphIsDrawnOfTheOneThatIsChosen) {
  const std::string graph = (folder_ / "two.svg").string();
  EXPECT_EQ(run({"render", step("two"), "-o", graph}), 2);
  EXPECT_THAT(err_, HasSubstr("choose it by --solid 0 to --solid 1"));
  EXPECT_EQ(run({"render", step("two"), "-o", graph, "--solid", "1"}), 0) << err_;
  EXPECT_EQ(run({"render", study(), "-o", (folder_ / "x.png").string(), "--solid", "0"}), 2);
  EXPECT_THAT(err_, HasSubstr("--solid chooses one of the solids of a CAD file"));
}

}  // namespace
}  // namespace isopatch::app
