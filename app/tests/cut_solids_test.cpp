#include "app/problem/cut_solids.hpp"

#include "app/tests/program_fixture.hpp"
#include "geometry/base/atomic_file.hpp"

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

class CutSolidsOfStudies : public Program {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  json summary() const { return json::parse(read_file(results() / "summary.json")); }
};

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
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("1 cut into 2 parts"));
  EXPECT_THAT(out_, HasSubstr("2 hexahedra"));
  EXPECT_THAT(out_, HasSubstr("block_0.step to block_1.step"));
  ASSERT_EQ(run({"info", file("blocks/block_0.step")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("ready for parameterization"));
  EXPECT_THAT(out_, HasSubstr("face 1"));
}

TEST_F(CutSolidsOfStudies, AreDescribedInJson) {
  write_file(file("l.off"), l_shape);
  ASSERT_EQ(run({"segment", file("l.off"), "-o", file("blocks"), "--json"}), 0) << err_;
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
  EXPECT_EQ(
      run_text(
          l_study +
          "[segmentation]\ntime_limit = 1e-9\n[[support]]\nfaces = [\"face 0\"]\ndisplacement = [0, 0, 0]\n"),
      2);
  EXPECT_THAT(err_, HasSubstr("solid 'l': no way"));
  EXPECT_THAT(err_, HasSubstr("raise time_limit"));
  EXPECT_EQ(run_text("[model]\nblocks = [\"l.off\"]\n[segmentation]\nbeam = 3\n[[material]]\nyoung = "
                     "1\npoisson = 0\n[[support]]\nfaces "
                     "= [\"face 0\"]\ndisplacement = [0, 0, 0]\n"),
            2);
  EXPECT_THAT(err_, HasSubstr("[segmentation]"));
}

}  // namespace
}  // namespace isopatch::app
