#include "app/problem/cut_solids.hpp"

#include "app/problem/block_file.hpp"
#include "app/problem/parameterized_model.hpp"
#include "app/tests/program_fixture.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::app {
namespace {

/// A prism of height 1 m over an L of area 3 m^2; face 0 is its bottom, face 1 its top, face 4 the side at y
/// = 1, x from 1 to 2.
const std::string l_shape =
    "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
    "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n";

const std::string l_study = R"([model]
file = "l.off"
[[material]]
young = 1000
poisson = 0.25
)";

/// A prism over a T, 1 m high: a stem on the middle of a bar that is cut off meets part of its side.
const std::string t_shape =
    "OFF\n16 10 0\n0 0 0\n3 0 0\n3 1 0\n2 1 0\n2 3 0\n1 3 0\n1 1 0\n0 1 0\n"
    "0 0 1\n3 0 1\n3 1 1\n2 1 1\n2 3 1\n1 3 1\n1 1 1\n0 1 1\n"
    "8 7 6 5 4 3 2 1 0\n8 8 9 10 11 12 13 14 15\n4 0 1 9 8\n4 1 2 10 9\n4 2 3 11 10\n4 3 4 12 11\n4 4 5 13 "
    "12\n"
    "4 5 6 14 13\n4 6 7 15 14\n4 7 0 8 15\n";

/// A house with a notch in its ridge: faces 5 and 6 share two vertices without an edge between them.
const std::string notched =
    "OFF\n14 9 0\n0 0 0\n0 2 0\n0 2 1\n0 1 2\n0 0 1\n3 0 0\n3 2 0\n3 2 1\n3 1 2\n3 0 1\n1 1 2\n2 1 2\n1.5 "
    "0.5 1.5\n"
    "1.5 1.5 1.5\n5 0 4 3 2 1\n5 5 6 7 8 9\n4 0 1 6 5\n4 1 2 7 6\n4 0 5 9 4\n7 2 3 10 13 11 8 7\n7 9 8 11 12 "
    "10 3 4\n"
    "3 10 12 13\n3 11 13 12\n";

class CutSolidsOfStudies : public Program {
 protected:
  BlocksInput input(const std::string& name) const {
    BlocksInput result;
    result.files.files = {file(name)};
    return result;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  json summary() const { return json::parse(read_file(results() / "summary.json")); }
};

TEST_F(CutSolidsOfStudies, SayWhichFacesOfThePlaneAreOne) {
  // The side at y = 0 in two.
  std::string divided = l_shape;
  divided.replace(divided.find("12 8 0"), 6, "14 9 0");
  divided.insert(divided.find("6 5 4"), "0.8 0 0\n0.8 0 1\n");
  divided.replace(divided.find("6 5 4 3 2 1 0\n6 6 7"), 19, "7 5 4 3 2 1 12 0\n7 6 13 7");
  divided.replace(divided.find("4 0 1 7 6\n"), 10, "4 0 12 13 6\n4 12 1 7 13\n");
  write_file(file("divided.off"), divided);
  BlocksInput of_divided = input("divided.off");
  of_divided.decomposition = segmentation::DecompositionOptions{.method = segmentation::Method::cuts};
  const std::vector<std::string> warnings = cut_solids(of_divided).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("face 2 and face 3 are 'face 2'"), std::string::npos) << warnings[0];
}

TEST_F(CutSolidsOfStudies, PassThePatchTest) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run_text(l_study + R"([[support]]
faces = ["face 0", "face 1", "face 2", "face 3", "face 4", "face 5", "face 6", "face 7"]
displacement_gradient = [[0.001, 0, 0], [0, 0, 0], [0, 0, 0]]
)"),
            0)
      << err_;
  // lambda + 2 mu = 1200 Pa; half of it times 1e-6 and 3 m^3.
  EXPECT_NEAR(summary()["results"]["internal_energy"].get<double>(), 1.8e-3, 1.8e-3 * 1e-9);
}

TEST_F(CutSolidsOfStudies, KeepFacesWholeForLoads) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run_text(l_study + R"([[support]]
faces = ["face 0"]
displacement = [0, 0, 0]
[[load]]
faces = ["face 1"]
traction = [0, 0, 10]
[[load]]
faces = ["face 4"]
traction = [0, 5, 0]
)"),
            0)
      << err_;
  const json reaction = summary()["results"]["reactions"][0]["force"];
  EXPECT_NEAR(reaction[2].get<double>(), -30, 1e-7);  // 3 m^2
  EXPECT_NEAR(reaction[1].get<double>(), -5, 1e-7);   // 1 m^2
}

TEST_F(CutSolidsOfStudies, AreWrittenAsStepFilesWithTheirFacesNames) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), "--method", "cuts", "-o", file("blocks")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("1 cut into 2 parts"));
  EXPECT_THAT(out_, HasSubstr("2 hexahedra"));
  EXPECT_THAT(out_, HasSubstr("block_0.step to block_1.step"));
  ASSERT_EQ(run({"info", file("blocks/block_0.step")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("ready for parameterization"));
  EXPECT_THAT(out_, HasSubstr("face 1"));
}

TEST_F(CutSolidsOfStudies, AreDescribedInJson) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), "--method", "cuts", "-o", file("blocks"), "--json"}), 0) << err_;
  const json body = json::parse(out_)["bodies"][0];
  EXPECT_EQ(body["name"], "l");
  EXPECT_EQ(body["cuts"], 1);
  EXPECT_EQ(body["parts"], 2);
  EXPECT_EQ(body["t_joints"], 0);
  EXPECT_EQ(body["hexahedra"], 2);
}

TEST_F(CutSolidsOfStudies, ReplaceThoseOfAnEarlierCommand) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks")}), 0) << err_;
  write_file(file("box.off"),
             "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n4 0 "
             "1 5 4\n4 1 2 6 5\n4 2 3 7 "
             "6\n4 3 0 4 7\n");
  ASSERT_EQ(run({"segment", file("box.off"), "-o", file("blocks")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("as it is"));
  EXPECT_TRUE(fs::exists(file("blocks/block_0.step")));
  EXPECT_FALSE(fs::exists(file("blocks/block_1.step")));
}

TEST_F(CutSolidsOfStudies, NeedAFolderThatCanBeWritten) {
  write_file(file("l.off"), l_shape);
  EXPECT_NE(run({"segment", file("l.off"), "-o", "/proc/blocks"}), 0);
  EXPECT_THAT(err_, HasSubstr("/proc/blocks"));
  EXPECT_THAT(err_, testing::Not(HasSubstr("bug")));
}

TEST_F(CutSolidsOfStudies, SayWhatStandsInTheWay) {
  write_file(file("l.off"), l_shape);
  EXPECT_EQ(run_text(l_study + "[segmentation]\nmethod = \"cuts\"\ntime_limit = 1e-9\n[[support]]\nfaces = "
                               "[\"face 0\"]\ndisplacement = [0, 0, 0]\n"),
            2);
  EXPECT_THAT(err_, HasSubstr("solid 'l': no way"));
  EXPECT_THAT(err_, HasSubstr("Raise time_limit"));
  EXPECT_EQ(run_text("[model]\nblocks = [\"l.off\"]\n[segmentation]\nbeam = 3\n[[material]]\nyoung = "
                     "1\npoisson = 0\n[[support]]\nfaces "
                     "= [\"face 0\"]\ndisplacement = [0, 0, 0]\n"),
            2);
  EXPECT_THAT(err_, HasSubstr("[segmentation]"));
}

TEST_F(CutSolidsOfStudies, AreTheSamePatchesFromTheFileOfBlocks) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("blocks.h5"));
  BlocksInput solid = input("l.off");
  solid.decomposition = segmentation::DecompositionOptions{};
  const geometry::PatchSet cut = parameterized(solid).patches,
                           stored = parameterized(input("blocks/blocks.h5")).patches;
  ASSERT_EQ(cut.patches.size(), 2U);
  ASSERT_EQ(stored.patches.size(), 2U);
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_EQ(cut.patches[p].control_points(), stored.patches[p].control_points());
  const std::string rest =
      "[[material]]\nyoung = 1000\npoisson = 0.25\n[[support]]\nfaces = [\"face 0\"]\ndisplacement = [0, 0, "
      "0]\n"
      "[[load]]\nfaces = [\"face 1\"]\ntraction = [0, 0, 10]\n";
  ASSERT_EQ(run_text("[model]\nfile = \"l.off\"\n" + rest), 0) << err_;
  const json from_solid = summary()["results"]["internal_energy"];
  ASSERT_EQ(run_text("[model]\nfile = \"blocks/blocks.h5\"\n" + rest), 0) << err_;
  EXPECT_THAT(err_, testing::Not(HasSubstr("cutting")));
  EXPECT_EQ(summary()["results"]["internal_energy"], from_solid);
  ASSERT_EQ(run({"info", file("blocks/blocks.h5")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("2 blocks"));
  EXPECT_THAT(out_, HasSubstr("all meet side to side"));
}

TEST_F(CutSolidsOfStudies, RefuseFilesOfBlocksThatAreNone) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks")}), 0) << err_;
  const std::string study_text = "[model]\nfile = \"blocks/blocks.h5\"\n",
                    rest =
                        "[[material]]\nyoung = 1\npoisson = 0\n[[support]]\nfaces = [\"face "
                        "0\"]\ndisplacement = [0, 0, 0]\n";
  EXPECT_EQ(run_text(study_text + "[segmentation]\nbeam = 3\n" + rest), 2);
  EXPECT_THAT(err_, HasSubstr("blocks already"));
  EXPECT_EQ(run_text(study_text + "length_unit = \"mm\"\n" + rest), 2);
  EXPECT_THAT(err_, HasSubstr("in metres already"));
  EXPECT_EQ(run({"run", file("blocks/blocks.h5")}), 2);
  EXPECT_THAT(err_, HasSubstr("is a model, not a study"));
  EXPECT_EQ(run({"render", file("blocks/blocks.h5"), "-o", file("picture.png")}), 2);
  EXPECT_THAT(err_, HasSubstr("no patches yet"));
  std::string bytes = read_file(file("blocks/blocks.h5"));
  // Somewhere in the shapes.
  const auto at = bytes.find("isopatch solids");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 100] = static_cast<char>(bytes[at + 100] ^ 1);
  write_file(file("blocks/blocks.h5"), bytes);
  EXPECT_ERROR(read_block_file(file("blocks/blocks.h5")), ErrorCode::bad_format, "cut the solids again");
}

TEST_F(CutSolidsOfStudies, MayKeepTheirTJoints) {
  write_file(file("t.off"), t_shape);
  ASSERT_EQ(run({"segment", file("t.off"), "-o", file("blocks"), "--t-joints", "keep"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("2 hexahedra, which may meet in parts of sides (kept)"));
  const segmentation::HexModel model = read_block_file(file("blocks/blocks.h5")).model;
  EXPECT_EQ(model.solids.size(), 2U);
  double volume = 0;
  for (const geometry::BrepFile& block : model.solids) volume += block.brep.volume();
  EXPECT_NEAR(volume, 5, 1e-9);
  ASSERT_GT(model.topology.t_joints.size(), 0U);
  // What lies in a side is listed whole: the areas of the rectangles add up to no more than the side.
  for (const geometry::TJoint& joint : model.topology.t_joints) {
    double share = 0;
    for (const geometry::SidePart& part : joint.parts) {
      ASSERT_TRUE(part.rectangle.has_value());
      share += (part.rectangle->high[0] - part.rectangle->low[0]) *
               (part.rectangle->high[1] - part.rectangle->low[1]);
    }
    EXPECT_LT(share, 1 + 1e-9);
  }
  ASSERT_EQ(run({"info", file("blocks/blocks.h5")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("1 T-joint, for studies with coupling.non_matching = \"nitsche\" or "
                              "\"mortar\":\n  "));
  EXPECT_THAT(out_, HasSubstr("of block 't"));
  EXPECT_THAT(read_file(file("blocks/report.html")), HasSubstr("\"t_joints\":["));
  const std::string rest =
      "[[material]]\nyoung = 1\npoisson = 0\n[[support]]\nfaces = [\"face 0\"]\ndisplacement = [0, 0, 0]\n";
  for (const std::string source :
       {"file = \"blocks/blocks.h5\"\n", "file = \"t.off\"\n[segmentation]\nt_joints = \"keep\"\n"}) {
    EXPECT_EQ(run_text("[model]\n" + source + rest), 2);
    EXPECT_THAT(err_, HasSubstr("T-joints"));
    EXPECT_THAT(err_, HasSubstr("couple them with coupling.non_matching = \"nitsche\""));
    EXPECT_THAT(err_, HasSubstr("t_joints = \"remove\""));
    EXPECT_THAT(err_, testing::Not(HasSubstr("fitting")));
  }
}

// Two bars beside each other of which each reaches beyond the other.
TEST_F(CutSolidsOfStudies, SayWhereSidesMeetOfWhichNeitherLiesWithinTheOther) {
  write_file(file("z.off"),
             "OFF\n16 10 0\n0 0 0\n2 0 0\n2 1 0\n3 1 0\n3 2 0\n1 2 0\n1 1 0\n0 1 0\n"
             "0 0 1\n2 0 1\n2 1 1\n3 1 1\n3 2 1\n1 2 1\n1 1 1\n0 1 1\n"
             "8 7 6 5 4 3 2 1 0\n8 8 9 10 11 12 13 14 15\n4 0 1 9 8\n4 1 2 10 9\n4 2 3 11 10\n4 3 4 12 11\n"
             "4 4 5 13 12\n4 5 6 14 13\n4 6 7 15 14\n4 7 0 8 15\n");
  ASSERT_EQ(run({"segment", file("z.off"), "-o", file("blocks"), "--t-joints", "keep"}), 0) << err_;
  ASSERT_EQ(read_block_file(file("blocks/blocks.h5")).model.topology.t_joints.size(), 0U);
  ASSERT_EQ(run({"info", file("blocks/blocks.h5")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("1 T-joint, for studies with coupling.non_matching"));
  EXPECT_THAT(out_, HasSubstr("of block 'z' meets z#1 in part\n"));
  const std::string rest =
      "[segmentation]\nt_joints = \"keep\"\n[[material]]\nyoung = 1\npoisson = 0\n[[support]]\n"
      "faces = [\"face 2\"]\ndisplacement = [0, 0, 0]\n";
  EXPECT_EQ(run_text("[model]\nfile = \"z.off\"\n" + rest), 2);
  EXPECT_THAT(err_, HasSubstr("of block 'z' meets z#1 in part; couple them with coupling.non_matching"));
  EXPECT_EQ(run_text("[model]\nfile = \"z.off\"\n" + rest + "[coupling]\nnon_matching = \"nitsche\"\n"), 0)
      << err_;
}

TEST_F(CutSolidsOfStudies, AreWrittenAsStepFilesAloneWhereTheyRunThroughEachOther) {
  write_file(file("l.off"), l_shape);
  write_file(file("again.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), file("again.off"), "-o", file("blocks")}), 0) << err_;
  EXPECT_THAT(err_, HasSubstr("warning: blocks.h5 is not written, since a study would refuse the blocks: "));
  EXPECT_TRUE(fs::exists(file("blocks/block_3.step")));
  EXPECT_TRUE(fs::exists(file("blocks/report.html")));
  EXPECT_FALSE(fs::exists(file("blocks/blocks.h5")));
}

TEST_F(CutSolidsOfStudies, AreWrittenThoughOthersAreGivenUp) {
  write_file(file("l.off"), l_shape);
  write_file(file("notched.off"), notched);
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks")}), 0) << err_;
  EXPECT_EQ(run({"segment", file("notched.off"), file("l.off"), "--method", "cuts", "-o", file("blocks")}),
            2);
  EXPECT_THAT(err_, HasSubstr("solid 'notched': its edge graph is not 3-connected: face 5 and face 6"));
  EXPECT_THAT(err_, HasSubstr("failure.html shows where"));
  EXPECT_THAT(out_, HasSubstr("notched: given up"));
  EXPECT_THAT(out_, HasSubstr("l: 1 cut into 2 parts"));
  EXPECT_TRUE(fs::exists(file("blocks/block_1.step")));
  EXPECT_TRUE(fs::exists(file("blocks/failure.html")));
  // Those of the earlier command.
  EXPECT_FALSE(fs::exists(file("blocks/report.html")));
  EXPECT_FALSE(fs::exists(file("blocks/blocks.h5")));
}

TEST_F(CutSolidsOfStudies, AreShownAsFarAsARunHadCutThem) {
  write_file(file("l.off"), l_shape);
  EXPECT_EQ(run_text(l_study + "[segmentation]\nmethod = \"cuts\"\ntime_limit = 1e-9\n[[support]]\nfaces = "
                               "[\"face 0\"]\ndisplacement = [0, 0, 0]\n"),
            2);
  EXPECT_THAT(err_, HasSubstr("report.html shows where"));
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("\"kind\":\"blocks\""));
}

TEST_F(CutSolidsOfStudies, AreForeseenByInfo) {
  write_file(file("l.off"), l_shape);
  write_file(file("notched.off"), notched);
  ASSERT_EQ(run({"info", file("l.off")}), 0) << err_;
  EXPECT_THAT(out_,
              testing::ContainsRegex("segmentation: looks swept along [xyz], "
                                     "or is cut if that takes fewer hexahedra: 8 faces, 1 concave edge \\("));
  ASSERT_EQ(run({"info", file("l.off"), "--json"}), 0) << err_;
  EXPECT_EQ(json::parse(out_)["solids"][0]["segmentation"]["concave_edges"].size(), 1U);
  ASSERT_EQ(run({"info", file("notched.off")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("segmentation: refused: its edge graph is not 3-connected: face 5 and face 6"));
  write_file(study(), l_study + "[[support]]\nfaces = [\"face 0\"]\ndisplacement = [0, 0, 0]\n");
  ASSERT_EQ(run({"info", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("fewer hexahedra: 8 faces"));
}

TEST_F(CutSolidsOfStudies, TellHowFarTheyAreOnATerminal) {
  write_file(file("l.off"), l_shape);
  write_file(file("notched.off"), notched);
  EXPECT_EQ(run({"segment", file("notched.off"), file("l.off"), "-o", file("blocks")}, true), 2);
  EXPECT_THAT(err_, HasSubstr("body 2 of 2: cutting 'l': 0 cuts, 1 part unfinished, 0 of 60 s"));
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks")}), 0) << err_;
  EXPECT_THAT(err_, HasSubstr("isopatch: cutting 'l'\n"));
  EXPECT_THAT(err_, testing::Not(HasSubstr("unfinished")));
}

}  // namespace
}  // namespace isopatch::app
