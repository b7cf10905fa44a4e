#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "app/problem/patch_file.hpp"
#include "app/problem/solid_file.hpp"
#include "app/problem/solid_stages.hpp"
#include "app/study/config_text.hpp"
#include "app/study/parse_study.hpp"
#include "app/tests/program_fixture.hpp"
#include "app/tests/stl_file.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/read_triangles.hpp"

namespace isopatch::app {
namespace {

using testing::ElementsAre;

/// A drilled block of triangles, held at one side and pulled at the other.
const std::string drilled_study = R"([model]
file = "drilled.stl"
length_unit = "mm"
[[material]]
young = 1e9
poisson = 0.25
[[support]]
faces = ["plane_1"]
displacement = [0, 0, 0]
[[load]]
faces = ["plane_2"]
traction = [1e5, 0, 0]
[output]
fields = false
report = false
error_estimate = false
)";

class Stages : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    test::stl_file(folder_, "drilled");
  }

  json summary() const { return json::parse(read_file(results() / "summary.json")); }

  /// Whether each stage of the last run was kept by the one before.
  std::vector<bool> kept() const {
    std::vector<bool> result;
    const json last = summary();
    for (const json& stage : last["stages"]) result.push_back(stage["kept"]);
    return result;
  }

  BlocksInput input(const std::string& more = "") const {
    const Study study = parse_study(drilled_study + more, (folder_ / "study.toml").string());
    BlocksInput solids = std::get<BlocksInput>(study.model.source);
    solids.stages.folder = folder_ / "kept";
    return solids;
  }
};

TEST_F(Stages, AreKeptAndALoadIsSolvedAlone) {
  ASSERT_EQ(run_text(drilled_study), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(false, false, false));
  const double before = summary()["results"]["internal_energy"];
  ASSERT_EQ(run_text(replaced(drilled_study, "1e5", "2e5")), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(true, true, true));
  EXPECT_THAT(out_, HasSubstr("solid, hexahedra, patches as before"));
  EXPECT_THAT(err_, HasSubstr("hexahedra: as before, from"));
  // The energy grows with the load's square, to the last bit: the load is doubled, and so are all numbers.
  EXPECT_DOUBLE_EQ(summary()["results"]["internal_energy"], 4 * before);
  // Kept patches are those that were made, to the last bit.
  const double again = summary()["results"]["internal_energy"];
  ASSERT_EQ(run({"run", study(), "--from", "solid"}), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(false, false, false));
  EXPECT_EQ(summary()["results"]["internal_energy"].get<double>(), again);
}

TEST_F(Stages, AreMadeAgainFromTheFirstThatChanged) {
  ASSERT_EQ(run_text(drilled_study), 0) << err_;
  ASSERT_EQ(run_text(drilled_study + "[parameterization]\ndegree = 2\n"), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(true, true, false));
  ASSERT_EQ(run_text(drilled_study + "[parameterization]\ndegree = 2\n[segmentation]\nbeam = 5\n"), 0)
      << err_;
  EXPECT_FALSE(kept()[1]);
  EXPECT_TRUE(kept()[0]);
  // Another comment in the file are other bytes, but the same solid.
  std::string bytes = read_file(folder_ / "drilled.stl");
  bytes[10] = 'x';
  write_file(folder_ / "drilled.stl", bytes);
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(false, true, true));
}

TEST_F(Stages, AreMadeAgainWhereTheirFilesAreDamaged) {
  ASSERT_EQ(run_text(drilled_study), 0) << err_;
  const fs::path blocks = results() / "stages" / "blocks.h5";
  std::string bytes = read_file(blocks);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_file(blocks, bytes);
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(true, false, true));
  write_file(results() / "stages" / "stages.json", "{\"solid\": 3, \"hexahedra\": {\"key\":");
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(false, false, false));
}

TEST_F(Stages, DoNotGrowInNumber) {
  ASSERT_EQ(run_text(drilled_study), 0) << err_;
  const std::vector<std::string> files = files_below(results() / "stages");
  ASSERT_EQ(run_text(drilled_study + "[parameterization]\ndegree = 2\n"), 0) << err_;
  EXPECT_THAT(files_below(results() / "stages"), testing::UnorderedElementsAreArray(files));
  EXPECT_EQ(files.size(), 5u);
}

TEST_F(Stages, AreNotKeptIfTheStudySaysSo) {
  ASSERT_EQ(run_text(drilled_study + "stages = false\n"), 0) << err_;
  EXPECT_FALSE(fs::exists(results() / "stages"));
  EXPECT_EQ(run({"run", study(), "--to", "solid"}), 2);
  EXPECT_THAT(err_, HasSubstr("output.stages"));
}

TEST_F(Stages, EndWhereToSays) {
  ASSERT_EQ(run_text(replaced(drilled_study, "report = false\n", ""), {"--to", "hexahedra"}), 0) << err_;
  EXPECT_THAT(files_below(results()),
              testing::UnorderedElementsAre("stages/solids.h5", "stages/solid.step", "stages/blocks.h5",
                                            "stages/stages.json", "stages/report.html"));
  EXPECT_THAT(read_file(results() / "stages" / "report.html"), HasSubstr("\"name\":\"cylinder_1\""));
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  EXPECT_THAT(kept(), ElementsAre(true, true, false));
  // The blocks are a model by themselves.
  EXPECT_EQ(run({"info", (results() / "stages" / "blocks.h5").string()}), 0) << err_;
}

TEST_F(Stages, AreForSolidsAlone) {
  for (const std::string option : {"--from", "--to"}) {
    EXPECT_EQ(run_text(bar, {option, "patches"}), 2);
    EXPECT_THAT(err_, HasSubstr("has patches already"));
  }
}

TEST_F(Stages, ThatFailLeaveWhatWasFinishedAndAPicture) {
  test::stl_file(folder_, "spring");
  const std::string text = replaced(drilled_study, "report = false\n", "");
  EXPECT_EQ(run_text(replaced(text, "drilled.stl", "spring.stl")), 2);
  EXPECT_THAT(err_, HasSubstr("report.html shows it"));
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("\"is_faulty\":true"));
  // A body that cannot be cut in the time given, of which the solid stays.
  EXPECT_EQ(run_text(text + "[segmentation]\nmethod = \"cuts\"\ntime_limit = 1e-9\n"), 2);
  EXPECT_THAT(files_below(results()), testing::Contains("stages/solids.h5"));
}

TEST_F(Stages, SolidsComeBackWithTheirTriangles) {
  const FoundSolids found = solids_of_files(input());
  write_file(folder_ / "solids.h5", solid_file_bytes(found));
  const FoundSolids back = read_solid_file(folder_ / "solids.h5");
  ASSERT_EQ(back.triangles.size(), 1u);
  EXPECT_EQ(back.triangles[0].mesh, found.triangles[0].mesh);
  EXPECT_EQ(back.triangles[0].faces, found.triangles[0].faces);
  EXPECT_EQ(back.triangles[0].solid, "drilled");
  ASSERT_EQ(back.read.solids.size(), 1u);
  EXPECT_EQ(back.read.solids[0].brep.volume(), found.read.solids[0].brep.volume());
  EXPECT_EQ(back.read.solids[0].brep.faces()[0].name, "plane_1");
}

/// Moves the vertices along the drilled block's bore, whose axis is along z, in and out.
void dent_bore(const std::filesystem::path& file, const Eigen::Vector2d& axis, double by) {
  geometry::TriangleMesh mesh = geometry::read_triangles(file).mesh;
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i) {
    const Eigen::Vector2d out = mesh.vertices.col(i).head<2>() - axis;
    if (out.norm() > 5.01) continue;
    mesh.vertices.col(i).head<2>() += by * std::sin(7 * std::atan2(out.y(), out.x())) * out.normalized();
  }
  write_file(file, geometry::to_stl(mesh));
}

// Vertices that are 3e-4 of the size off tell no more of the part than that.
TEST_F(Stages, PatchesAreNoNearerThanTheSolidIsToItsTriangles) {
  dent_bore(folder_ / "drilled.stl", {15, 10}, 0.01);
  const BlocksInput loose = input("[reconstruction]\ntolerance = 1e-3\n");
  const double off = solids_of_files(loose).triangles.at(0).deviation;
  const auto made = staged_patches(loose, Stage::patches).made->report;
  EXPECT_GT(off, 1.1e-4 * made.size);
  EXPECT_NEAR(made.tolerance / off, 1, 0.02);  // of the solid's size and of its blocks'
  BlocksInput asked = loose;
  asked.gives_tolerance = true;
  asked.stages.folder = folder_ / "asked";
  EXPECT_NEAR(staged_patches(asked, Stage::patches).made->report.tolerance, 1e-4 * made.size, 1e-12);
}

TEST_F(Stages, PatchesComeBackWithTheirReport) {
  const segmentation::Parameterization made = *staged_patches(input(), Stage::patches).made;
  const std::string bytes = patch_file_bytes(made);
  write_file(folder_ / "patches.h5", bytes);
  segmentation::Parameterization back = read_patch_file(folder_ / "patches.h5");
  EXPECT_EQ(back.patches, made.patches);
  EXPECT_EQ(back.report.patches.size(), made.report.patches.size());
  EXPECT_EQ(back.report.faces[0].deviations.values, made.report.faces[0].deviations.values);
  // Whatever was read is written as it was.
  EXPECT_EQ(patch_file_bytes(back), bytes);
}

TEST_F(Stages, TextOfATableKnowsValuesNotLayout) {
  const auto text = [](const std::string& toml) { return config_text(parse_toml(toml, "a"), {"left"}); };
  EXPECT_EQ(text("a = 1\nb = \"x\""), text("b   = 'x' # no\na = 1\nleft = 3"));
  EXPECT_NE(text("a = 1"), text("a = 1.0"));
  EXPECT_NE(text("a = [1, 2]"), text("a = [12]"));
  EXPECT_NE(text("a = \"b=1\""), text("a = \"\"\nb = 1"));
  EXPECT_NE(text("a = 0.1"), text("a = 0.10000000000000002"));
}

}  // namespace
}  // namespace isopatch::app
