#include <fmt/format.h>

#include <regex>

#include "app/tests/program_fixture.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/write_brep.hpp"

namespace isopatch::app {
namespace {

/// A unit cube with its vertices and faces as given.
std::string off(const std::string& vertices, const std::string& faces) {
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  return "OFF\n" + std::to_string(lines(vertices)) + " " + std::to_string(lines(faces)) + " 0\n" + vertices +
         faces;
}
const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
const std::string five_sides = "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n";
const std::string sides = five_sides + "4 3 0 4 7\n";
/// Beside it, over x from 1 to 2.
const std::string next_corners = "1 0 0\n2 0 0\n2 1 0\n1 1 0\n1 0 1\n2 0 1\n2 1 1\n1 1 1\n";

const std::string cube_study = R"(title = "two cubes"
[model]
blocks = ["a.off", "b.off"]
[[material]]
young = 1000
poisson = 0.25
[[support]]
faces = ["a:face 5"]
displacement = [0, 0, 0]
[[load]]
faces = ["b:face 3"]
traction = [10, 0, 0]
)";

class Blocks : public Program {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// The data inside a page.
  static json page_data(const fs::path& page) {
    const std::string html = read_file(page), begin = "id=\"isopatch-data\">";
    const auto from = html.find(begin) + begin.size();
    return json::parse(html.substr(from, html.find("</script>", from) - from));
  }
  /// Parameterizes a bad solid with a report and returns the report's data.
  json refused(const std::string& text) {
    write_file(file("part.off"), text);
    EXPECT_EQ(run({"parameterize", file("part.off"), "-o", file("p.xml"), "--report", file("p.html")}), 2);
    EXPECT_FALSE(fs::exists(file("p.xml")));
    EXPECT_THAT(err_, HasSubstr("p.html shows where"));
    if (!fs::exists(file("p.html"))) return {};
    json data = page_data(file("p.html"));
    EXPECT_EQ(data["kind"], "faults");
    EXPECT_THAT(err_, HasSubstr(data["summary"]["message"].get<std::string>()));
    return data;
  }
  static std::vector<std::string> faulty(const json& list) {
    std::vector<std::string> names;
    for (const json& item : list)
      if (item["is_faulty"]) names.push_back(item["name"]);
    return names;
  }
  static std::vector<std::string> names(const json& list) {
    std::vector<std::string> result;
    for (const json& item : list) result.push_back(item["name"]);
    return result;
  }
};

using testing::ElementsAre;
using testing::UnorderedElementsAre;

TEST_F(Blocks, AnOpenShellIsShownWithItsEdges) {
  const json data = refused(off(corners, five_sides));
  EXPECT_THAT(
      err_,
      HasSubstr("vertex 0 at (0, 0, 0) m and vertex 3 at (0, 1, 0) m belongs to one face only: face 0"));
  EXPECT_THAT(faulty(data["faults"]["faces"]),
              ElementsAre("part: face 0", "part: face 1", "part: face 2", "part: face 4"));
  EXPECT_EQ(faulty(data["faults"]["lines"]).size(), 4u);
  EXPECT_EQ(data["summary"]["solids"][0]["faces"], 5);
  EXPECT_THAT(data["summary"]["solids"][0]["state"].get<std::string>(),
              HasSubstr("4 edges with one face only"));
}

TEST_F(Blocks, ANonManifoldEdgeIsShownWithItsFaces) {
  const json data = refused(off(corners, sides + "4 0 1 6 7\n"));
  EXPECT_THAT(err_, HasSubstr("belongs to more than two faces: faces 0 and 2 and 6"));
  EXPECT_THAT(faulty(data["faults"]["faces"]), testing::Contains("part: face 6"));
  EXPECT_GE(faulty(data["faults"]["lines"]).size(), 2u);
}

/// A STEP file whose last plane lies elsewhere: all coordinates of the point that it goes through grow.
std::string with_last_plane_moved(const std::string& step, double distance) {
  const auto find = [&](const std::string& pattern) {
    std::smatch found, last;
    for (auto from = step.begin(); std::regex_search(from, step.end(), found, std::regex(pattern));
         from = found.suffix().first)
      last = found;
    return last;
  };
  const std::string frame = find(R"(PLANE\('',#(\d+)\))")[1];
  const std::string origin = find("#" + frame + R"( = AXIS2_PLACEMENT_3D\('',#(\d+))")[1];
  const std::smatch point = find("#" + origin + R"( = CARTESIAN_POINT\('',\(([^,]+),([^,]+),([^)]+)\)\))");
  const auto moved = [&](std::size_t i) { return fmt::format("{:#.15g}", std::stod(point[i]) + distance); };
  const std::string now =
      fmt::format("#{} = CARTESIAN_POINT('',({},{},{}))", origin, moved(1), moved(2), moved(3));
  return std::string(step.begin(), point[0].first) + now + std::string(point[0].second, step.end());
}

TEST_F(Blocks, AFaceOffItsEdgesIsShownAndRefused) {
  write_file(file("part.off"), off(corners, sides));
  geometry::write_brep(file("part.step"), geometry::read_brep(file("part.off")).brep, {.unit = "m"});
  write_file(file("part.step"), with_last_plane_moved(read_file(file("part.step")), 0.125));
  EXPECT_EQ(run({"info", file("part.step")}), 2);
  EXPECT_THAT(out_, HasSubstr("ready for repair"));
  EXPECT_THAT(out_, HasSubstr("largest gap between an edge and its face 125 mm (edge "));
  EXPECT_THAT(err_, HasSubstr("lies 0.125 m (0.072 of the size) off its edge"));
  EXPECT_EQ(run({"parameterize", file("part.step"), "-o", file("p.xml"), "--report", file("p.html")}), 2);
  EXPECT_FALSE(fs::exists(file("p.xml")));
  EXPECT_THAT(err_, HasSubstr("part.step: the geometry contradicts itself: face "));
  const json data = page_data(file("p.html"));
  EXPECT_EQ(faulty(data["faults"]["faces"]).size(), 1u);
}

TEST_F(Blocks, AFiveCorneredFaceIsShownWithItsCorners) {
  const json data = refused(
      off(corners + "0.5 0 0\n", "5 0 3 2 1 8\n4 4 5 6 7\n5 0 8 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"));
  EXPECT_THAT(err_, HasSubstr("face 0 has 5 corners"));
  EXPECT_THAT(faulty(data["faults"]["faces"]), ElementsAre("part: face 0"));
  EXPECT_EQ(data["faults"]["faces"][0]["remark"], "5 corners");
  EXPECT_THAT(names(data["faults"]["places"]),
              UnorderedElementsAre("vertex 0", "vertex 1", "vertex 2", "vertex 3", "vertex 8"));
}

TEST_F(Blocks, AnEdgeWithoutLengthIsShown) {
  std::string same = corners;
  same.replace(same.find("1 1 1\n"), 6, "0 1 1\n");
  const json data = refused(off(same, sides));
  EXPECT_THAT(err_, HasSubstr("edge of face 1 has no length: vertex 6"));
  EXPECT_THAT(faulty(data["faults"]["faces"]), ElementsAre("part: face 1"));
  EXPECT_EQ(data["faults"]["places"][0]["point"], json({0.0, 1.0, 1.0}));
}

TEST_F(Blocks, ASelfIntersectingFaceIsShownWithTheCrossing) {
  std::string crossed = corners;
  crossed.replace(crossed.find("1 1 1\n"), 6, "-0.5 0.5 1\n");
  const json data = refused(off(crossed, sides));
  EXPECT_THAT(
      err_, HasSubstr("outline of face 1 with the vertices 4, 5, 6, 7 crosses itself at (0, 0.333333, 1) m"));
  EXPECT_THAT(faulty(data["faults"]["faces"]), ElementsAre("part: face 1"));
  EXPECT_NEAR(data["faults"]["places"][0]["point"][1].get<double>(), 1 / 3.0, 1e-12);
}

/// STEP with its first faces styled: as many as there are colours, each the three numbers of COLOUR_RGB.
std::string coloured(std::string step, const std::vector<std::string>& colours) {
  std::string styles;
  std::size_t at = 0;
  int id = 900000;
  for (const std::string& colour : colours) {
    at = step.find("ADVANCED_FACE(", at + 1);
    const std::size_t begin = step.rfind('#', at);
    const std::string face = step.substr(begin, step.find_first_of(" =", begin) - begin);
    const auto add = [&](const std::string& text) { styles += fmt::format("#{}={};\n", id++, text); };
    add("COLOUR_RGB(''," + colour + ")");
    add(fmt::format("FILL_AREA_STYLE_COLOUR('',#{})", id - 1));
    add(fmt::format("FILL_AREA_STYLE('',(#{}))", id - 1));
    add(fmt::format("SURFACE_STYLE_FILL_AREA(#{})", id - 1));
    add(fmt::format("SURFACE_SIDE_STYLE('',(#{}))", id - 1));
    add(fmt::format("SURFACE_STYLE_USAGE(.BOTH.,#{})", id - 1));
    add(fmt::format("PRESENTATION_STYLE_ASSIGNMENT((#{}))", id - 1));
    add(fmt::format("STYLED_ITEM('',(#{}),{})", id - 1, face));
  }
  return step.insert(step.rfind("ENDSEC;"), styles);
}

TEST_F(Blocks, ColoursOfStepFacesSelectBoundaries) {
  write_file(file("cube.off"), off(corners, sides));
  geometry::write_brep(file("cube.step"), geometry::read_brep(file("cube.off")).brep);
  // Faces 0 and 1 of the cube are z = 0 and z = 1, face 2 is y = 0.
  write_file(file("cube.step"),
             coloured(read_file(file("cube.step")), {"0.2,0.4,0.6", "0.2,0.4,0.6", "1.,0.,0."}));
  ASSERT_EQ(run({"info", file("cube.step")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("#336699"));
  const std::string text = R"(title = "cube"
[model]
blocks = ["cube.step"]
[[material]]
young = 1000
poisson = 0
[[support]]
faces = ["#ff0000"]
displacement = [0, 0, 0]
[[load]]
faces = ["#336699"]
traction = [0, 10, 0]
)";
  ASSERT_EQ(run_text(text), 0) << err_;
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_NEAR(summary["loads"][0]["total"][1].get<double>(), 20, 1e-9) << summary["loads"];
  EXPECT_EQ(run_text(replaced(text, "#336699", "#336698")), 2);
  EXPECT_THAT(err_, HasSubstr("no boundary is named \"#336698\" (did you mean '#336699'?)"));
}

/// STEP with names for its first faces, which the writer leaves without.
std::string named_faces(std::string step, const std::vector<std::string>& names) {
  std::size_t at = 0;
  for (const std::string& name : names) {
    at = step.find("ADVANCED_FACE('", at + 1);
    const std::size_t begin = at + 15;
    step.replace(begin, step.find('\'', begin) - begin, name);
  }
  return step;
}

TEST_F(Blocks, NamesOfStepFacesAreReportedAsTheStudyGivesThem) {
  write_file(file("cube.off"), off(corners, sides));
  geometry::write_brep(file("cube.step"), geometry::read_brep(file("cube.off")).brep, {.unit = "m"});
  // z = 0, z = 1, y = 0; the second has the name of a side of the patch, and the third that of the first's
  // colour.
  write_file(
      file("cube.step"),
      coloured(named_faces(read_file(file("cube.step")), {"bore", "0:west", "#ff0000"}), {"1.,0.,0."}));
  const std::string text = R"(title = "cube"
[model]
blocks = ["cube.step"]
[[material]]
young = 1000
poisson = 0
[[support]]
name = "clamp"
faces = ["bore"]
displacement = [0, 0, 0]
[[load]]
faces = ["face:0:west"]
traction = [0, 0, 10]
)";
  ASSERT_EQ(run_text(text), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("support 1 (clamp): displacement on bore (1 face), 1 m^2\n"));
  EXPECT_THAT(out_, HasSubstr("load 1: traction on face:0:west (1 face), 1 m^2\n"));
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_THAT(summary["supports"][0]["given"], ElementsAre("bore"));
  EXPECT_THAT(summary["loads"][0]["given"], ElementsAre("face:0:west"));
  ASSERT_EQ(summary["loads"][0]["faces"].size(), 1u);
  EXPECT_NE(summary["loads"][0]["faces"][0], summary["supports"][0]["faces"][0]);
  const json shown = page_data(results() / "report.html")["summary"];
  EXPECT_EQ(shown["loads"][0]["given"], summary["loads"][0]["given"]);
  ASSERT_EQ(run({"info", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("displacement on bore (1 face), 1 m^2"));
  // Without the form that says which, both meanings are named.
  EXPECT_EQ(run_text(replaced(text, "face:0:west", "0:west")), 2);
  EXPECT_THAT(
      err_,
      HasSubstr("the name \"0:west\" has two meanings: the faces of that name, which is \"face:0:west\" "
                "in full, and the west side of patch 0, \"side:0:west\"; write one of these"));
  EXPECT_EQ(run_text(replaced(text, "face:0:west", "#ff0000")), 2);
  EXPECT_THAT(err_, HasSubstr("\"face:#ff0000\""));
  EXPECT_THAT(err_, HasSubstr("\"colour:#ff0000\""));
  ASSERT_EQ(run_text(replaced(text, "face:0:west", "face:#ff0000")), 0) << err_;
  const json by_name = json::parse(read_file(results() / "summary.json"));
  EXPECT_NE(by_name["loads"][0]["faces"], summary["supports"][0]["faces"]);
  ASSERT_EQ(run_text(replaced(text, "\"bore\"", "\"colour:#FF0000\"")), 0) << err_;
  const json by_colour = json::parse(read_file(results() / "summary.json"));
  EXPECT_EQ(by_colour["supports"][0]["faces"], summary["supports"][0]["faces"]);
}

TEST_F(Blocks, BodiesOfStepFilesHaveOneNameInEveryCommandAndInStudies) {
  for (const auto& [name, points] : {std::pair("foot", corners), std::pair("leg", next_corners)}) {
    write_file(file("part.off"), off(points, sides));
    geometry::write_brep(file(std::string(name) + ".step"), geometry::read_brep(file("part.off")).brep,
                         {.unit = "m"});
    std::string text = read_file(file(std::string(name) + ".step"));
    const std::size_t product = text.find("PRODUCT('");
    ASSERT_NE(product, text.npos);
    const std::size_t end = text.find('\'', product + 9), second = text.find('\'', end + 1);
    text.replace(second + 1, text.find('\'', second + 1) - second - 1, "the " + std::string(name));
    write_file(file(std::string(name) + ".step"), text);
  }
  ASSERT_EQ(run({"info", file("foot.step")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("1 body, unit of length: m\n"));
  EXPECT_THAT(out_, HasSubstr("body 0 'the foot'"));
  const std::string text = R"(title = "stool"
[model]
blocks = ["foot.step", "leg.step"]
[[material]]
patches = ["the foot"]
name = "hard"
young = 2000
poisson = 0
[[material]]
patches = ["the leg"]
name = "soft"
young = 1000
poisson = 0
[[support]]
faces = ["the foot:face 0", "the leg:face 0"]
displacement = [0, 0, 0]
[[load]]
faces = ["the foot:face 1"]
traction = [0, 0, 10]
)";
  ASSERT_EQ(run_text(text), 0) << err_;
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_EQ(summary["materials"][0]["patches"], json::array({0}));
  EXPECT_EQ(summary["materials"][1]["patches"], json({1}));
  EXPECT_EQ(run_text(replaced(text, "[\"the leg\"]", "[\"the lag\"]")), 2);
  EXPECT_THAT(err_, HasSubstr("no patch is called \"the lag\" (did you mean 'the leg'?)"));
}

TEST_F(Blocks, WhatOfAFileCannotBeReadIsAnErrorUnlessTheStudyAllowsIt) {
  write_file(file("cube.off"), off(corners, sides));
  geometry::write_brep(file("cube.step"), geometry::read_brep(file("cube.off")).brep);
  std::string step = read_file(file("cube.step"));
  step.insert(step.rfind("ENDSEC;"), "#9000 = OFFSET_SURFACE('',#9999,1.,.F.);\n");
  write_file(file("cube.step"), step);
  EXPECT_EQ(run({"info", file("cube.step")}), 2);
  EXPECT_THAT(out_, HasSubstr("ready for parameterization"));
  EXPECT_THAT(err_, HasSubstr("#9000 = OFFSET_SURFACE refers to #9999, which is not in the file"));
  EXPECT_EQ(run({"info", file("cube.step"), "--allow-partial"}), 0) << err_;
  EXPECT_THAT(err_, HasSubstr("warning"));
  const fs::path patches = folder_ / "patches.xml";
  EXPECT_EQ(run({"parameterize", file("cube.step"), "-o", patches.string()}), 2);
  EXPECT_THAT(err_, HasSubstr("--allow-partial"));
  EXPECT_EQ(run({"parameterize", file("cube.step"), "-o", patches.string(), "--allow-partial"}), 0) << err_;
  EXPECT_THAT(err_, HasSubstr("refers to #9999"));
}

TEST_F(Blocks, AWrongPairIsShownInTheReportOfARun) {
  write_file(file("a.off"), off(corners, sides));
  write_file(file("b.off"), off(next_corners, sides));
  write_file(file("pairs.txt"), "a 3 b 3\n");
  const std::string text = replaced(cube_study, "\"b.off\"]", "\"b.off\"]\npairs = \"pairs.txt\"");
  EXPECT_EQ(run_text(text), 2);
  EXPECT_THAT(err_, HasSubstr("pair 0: faces a:face 3 and b:face 3 do not meet"));
  EXPECT_THAT(err_, HasSubstr("report.html shows where"));
  ASSERT_TRUE(fs::exists(results() / "report.html"));
  EXPECT_FALSE(fs::exists(results() / "summary.json"));
  const json data = page_data(results() / "report.html");
  EXPECT_THAT(faulty(data["faults"]["faces"]), ElementsAre("a: face 3", "b: face 3"));
  EXPECT_EQ(data["title"], "two cubes");
  // No page where none is asked for.
  fs::remove_all(results());
  EXPECT_EQ(run_text(text, {"--set", "output.report=false"}), 2);
  EXPECT_FALSE(fs::exists(results()));
}

TEST_F(Blocks, SolidsThatAreWrongCostNoEarlierResults) {
  write_file(file("a.off"), off(corners, sides));
  write_file(file("b.off"), off(next_corners, sides));
  ASSERT_EQ(run_text(cube_study), 0) << err_;
  const std::string before = read_file(results() / "results.h5");
  write_file(file("pairs.txt"), "a 3 b 3\n");
  EXPECT_EQ(run_text(replaced(cube_study, "\"b.off\"]", "\"b.off\"]\npairs = \"pairs.txt\"")), 2);
  EXPECT_EQ(read_file(results() / "results.h5"), before);
  EXPECT_TRUE(fs::exists(results() / "summary.json"));
}

TEST_F(Blocks, HaveTwoElementsAlongEachDirectionWhereNothingSaysHowFine) {
  write_file(file("a.off"), off(corners, sides));
  write_file(file("b.off"), off(next_corners, sides));
  const auto elements = [&](const std::string& more) {
    EXPECT_EQ(run_text(cube_study + more), 0) << err_;
    return json::parse(read_file(results() / "summary.json"))["discretization"]["elements"].get<int>();
  };
  EXPECT_EQ(elements(""), 16);
  EXPECT_EQ(elements("[discretization]\ndegree = 3\n"), 16);
  EXPECT_EQ(elements("[discretization]\nelements_per_direction = 1\n"), 2);
  EXPECT_EQ(elements("[discretization]\nmax_size = 5\n"), 2);
  EXPECT_EQ(elements("[discretization]\nrefine = 0\n"), 2);
  EXPECT_EQ(elements("[discretization]\nrefine = 1\n"), 16);
  EXPECT_EQ(elements("[[discretization.patch]]\npatches = [0]\nelements_per_direction = 1\n"), 2);
  EXPECT_EQ(elements("[accuracy]\nenergy = \"50 %\"\n"), 2);
  ASSERT_EQ(run_text(cube_study, {"--levels", "2"}), 0) << err_;  // halves those
  EXPECT_EQ(json::parse(read_file(results() / "summary.json"))["discretization"]["elements"], 128);
}

TEST_F(Blocks, TheReportOfARunHasDeviationAndCertificate) {
  write_file(file("a.off"), off(corners, sides));
  write_file(file("b.off"), off(next_corners, sides));
  ASSERT_EQ(run_text(cube_study), 0) << err_;
  const json data = page_data(results() / "report.html");
  std::vector<std::string> keys;
  for (const json& field : data["scene"]["fields"]) keys.push_back(field["key"]);
  EXPECT_THAT(keys, testing::IsSupersetOf({"scaled_jacobian", "deviation", "determinant_bound"}));
  const json found = json::parse(read_file(results() / "summary.json"))["parameterization"];
  EXPECT_EQ(found["certified"], true);
  EXPECT_EQ(found["patches"].size(), 2u);
  EXPECT_EQ(found["faces"].size(), 11u);
  EXPECT_NEAR(found["patches"][1]["determinant_bound"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(found["patches"][0]["volume"].get<double>(), 1, 1e-12);
  EXPECT_EQ(found["patches"][0]["histogram"][9].get<int>(), 64);
  EXPECT_LT(found["largest_deviation"].get<double>(), 1e-12);
  int shared = 0;
  for (const json& face : found["faces"]) shared += face["sides"].size() == 2 ? 1 : 0;
  EXPECT_EQ(shared, 1);
}

TEST_F(Blocks, ParameterizeWritesPatchesAndTheirPage) {
  write_file(file("a.off"), off(corners, sides));
  ASSERT_EQ(run({"parameterize", file("a.off"), "-o", file("a.xml"), "--report", file("a.html")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("det J > 1"));
  EXPECT_THAT(out_, HasSubstr("largest deviation  0 m"));
  EXPECT_THAT(out_, HasSubstr("1 patch, 0 interfaces"));
  const json data = page_data(file("a.html"));
  EXPECT_EQ(data["kind"], "model");
  EXPECT_EQ(data["scene"]["patches"][0]["name"], "a");
  EXPECT_EQ(data["summary"]["parameterization"]["certified"], true);
  EXPECT_EQ(run({"info", file("a.xml")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("1 patch"));
}

TEST_F(Blocks, ParameterizeTakesAllOptionsOfTheStudysSection) {
  write_file(file("a.off"), off(corners, sides));
  ASSERT_EQ(run({"parameterize", file("a.off"), "-o", file("a.xml"), "--degree", "4", "--start-spans", "2",
                 "--max-spans", "8", "--wanted-quality", "0.1", "--no-optimize", "--same-point", "1e-4",
                 "--tolerance", "1e-5", "--method", "shared"}),
            0)
      << err_;
  ASSERT_EQ(run({"info", file("a.xml"), "--json"}), 0) << err_;
  EXPECT_EQ(json::parse(out_)["patches"][0]["degree"], json({4, 4, 4}));
  EXPECT_EQ(json::parse(out_)["patches"][0]["elements"], json({2, 2, 2}));
  EXPECT_EQ(run({"parameterize", file("a.off"), "-o", file("a.xml"), "--max-spans", "5000"}), 2);
  EXPECT_THAT(err_, HasSubstr("max_spans is 5000; its range is start_spans to 1024"));
}

// Its top has a corner of more than 180 degrees.
TEST_F(Blocks, AFoldIsInTheReportWithItsPlace) {
  std::string folded = corners;
  folded.replace(folded.find("1 1 1\n"), 6, "0.25 0.25 1\n");
  write_file(file("a.off"), off(folded, sides));
  EXPECT_EQ(run({"parameterize", file("a.off"), "-o", file("a.xml"), "--report", file("a.html")}), 1);
  EXPECT_THAT(err_, HasSubstr("patch 'a' is"));
  const json warning = page_data(file("a.html"))["scene"]["warnings"][0];
  EXPECT_EQ(warning["patch"], 0);
  EXPECT_NEAR(warning["point"][0].get<double>(), 0.25, 1e-6);
}

}  // namespace
}  // namespace isopatch::app
