#include <fmt/format.h>

#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

TEST_F(Program, InterruptedLeavesNoFile) {
  // Half a million elements take far longer than the time until the interrupt.
  const std::string command = fmt::format(
      "timeout -k 20 --preserve-status -s INT 0.3 {} run {} --set discretization.refine=6 >{} 2>&1",
      ISOPATCH_PROGRAM, study(), (folder_ / "log").string());
  EXPECT_EQ(shell(command), 130);
  EXPECT_THAT(files_below(folder_), testing::UnorderedElementsAre("study.toml", "log"));
  EXPECT_FALSE(std::filesystem::exists(results()));
}

TEST_F(Program, AFullDiskIsAnErrorAndLeavesNoPartOfAFile) {
  // The shell's file size limit stands for the disk: each write beyond it fails.
  const std::string log = (folder_ / "log").string();
  EXPECT_EQ(shell(fmt::format("(ulimit -f 2; exec {} run {} -q) 2>{}", ISOPATCH_PROGRAM, study(), log)), 3);
  EXPECT_THAT(read_file(log), HasSubstr("free some space or choose another output directory"));
  for (const std::string& name : files_below(folder_)) {
    EXPECT_THAT(name, testing::Not(HasSubstr("unfinished")));
    EXPECT_NE(name, "results/summary.json");
  }
}

void collect_keys(const json& value, const std::string& path, std::vector<std::string>& keys) {
  if (!value.is_object()) return keys.push_back(path);
  for (const auto& [name, inner] : value.items())
    collect_keys(inner, path.empty() ? name : path + "." + name, keys);
}

TEST_F(Program, RunWritesASummaryWithTheDocumentedKeys) {
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_EQ(summary["schema_version"], 2);
  EXPECT_EQ(summary["title"], "bar");
  EXPECT_EQ(summary["model"]["patches"], 2);
  EXPECT_EQ(summary["model"]["interfaces"], 1);
  EXPECT_EQ(summary["model"]["boundary_faces"], 10);
  EXPECT_NEAR(summary["model"]["volume"], 2, 1e-13);
  EXPECT_EQ(summary["discretization"]["dofs_uncoupled"], 162);
  EXPECT_EQ(summary["discretization"]["dofs_eliminated"], 135);
  EXPECT_EQ(summary["discretization"]["multipliers"], 27);
  EXPECT_EQ(summary["coupling"], "elimination");
  // A bar in uniaxial tension: u = 1e7 / 1e9 * 2, energy = 0.5 * force * u.
  EXPECT_NEAR(summary["results"]["internal_energy"], 1e5, 1e-5);
  EXPECT_NEAR(summary["results"]["external_work"], 1e5, 1e-5);
  EXPECT_NEAR(summary["results"]["max_von_mises"], 1e7, 1e-3);
  EXPECT_EQ(summary["results"]["reactions"][0]["support"], "guides");
  EXPECT_NEAR(summary["results"]["reactions"][0]["force"][0], -1e7, 1e-3);
  EXPECT_NEAR(summary["probes"][0]["displacement"][0], 0.02, 1e-13);
  EXPECT_GT(summary["memory"]["peak_bytes"], 1000000);
  std::vector<std::string> keys;
  collect_keys(summary, "", keys);
  const std::string documentation = read_file(fs::path(ISOPATCH_SOURCE_DIR) / "app/SUMMARY.md");
  for (const std::string& key : keys)
    EXPECT_THAT(documentation, HasSubstr("`" + (key.starts_with("timings.") ? "timings" : key) + "`"));
  for (const char* phase : {"model", "output", "total"})
    EXPECT_TRUE(summary["timings"].contains(phase)) << phase;
}

TEST_F(Program, RunPrintsAShortSummaryAndPlainProgress) {
  ASSERT_EQ(run({"run", study()}), 0);
  EXPECT_THAT(out_, HasSubstr("max displacement"));
  EXPECT_THAT(out_, HasSubstr("internal energy   100 kJ"));
  EXPECT_THAT(out_, HasSubstr("summary.json"));
  EXPECT_THAT(err_, StartsWith("isopatch: reading the model\n"));
  EXPECT_THAT(err_, testing::Not(HasSubstr("\033")));
  EXPECT_THAT(err_, testing::Not(HasSubstr("\r")));
  ASSERT_EQ(run({"run", study()}, true), 0);
  EXPECT_THAT(err_, HasSubstr("\r\033[Kreading the model   0 %"));
}

TEST_F(Program, QuietSaysNothing) {
  ASSERT_EQ(run({"run", study(), "--quiet"}), 0);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(err_, "");
  EXPECT_TRUE(fs::exists(results() / "summary.json"));
}

TEST_F(Program, RunWritesAllFilesOrOnlyThoseAskedFor) {
  ASSERT_EQ(run({"run", study()}), 0);
  for (const char* file : {"summary.json", "results.h5", "results.vtm", "results_boundaries.vtm",
                           "results_exact.vtm", "report.html", "fields/patch_000.vtu", "fields/patch_001.vtu",
                           "fields/boundary_000.vtu", "fields/exact_patch_001.vtu"})
    EXPECT_TRUE(fs::exists(results() / file)) << file;
  const fs::path other = folder_ / "a/b";
  ASSERT_EQ(run({"run", study(), "-o", other.string(), "--set", "output.fields=false", "--set",
                 "output.hdf5=false", "--set", "output.report=false"}),
            0);
  EXPECT_EQ(std::distance(fs::directory_iterator(other), {}), 1);
}

TEST_F(Program, AFailedRunWritesNothing) {
  EXPECT_EQ(
      run_text(replaced(bar, "faces = [\"x_min\", \"y_min\", \"z_min\"]", "faces = [\"y_min\", \"z_min\"]")),
      1);
  EXPECT_THAT(err_, HasSubstr("isopatch: error: "));
  EXPECT_FALSE(fs::exists(results()));
}

TEST_F(Program, AnOutputDirectoryThatCannotBeWrittenIsRefusedFirst) {
  write_file(folder_ / "file", "");
  EXPECT_EQ(run({"run", study(), "-o", (folder_ / "file").string()}), 3);
  EXPECT_THAT(err_, HasSubstr("cannot write to the output directory"));
  EXPECT_THAT(err_, HasSubstr("choose another one with --output DIR"));
  EXPECT_EQ(run({"run", study(), "-o", (folder_ / "file/below").string()}), 3);
  EXPECT_EQ(run({"run", study(), "-o", "/proc/isopatch"}), 3);
  EXPECT_THAT(err_, testing::Not(HasSubstr("reading the model")));
}

TEST_F(Program, ErrorsOfInputGiveTheirExitCodes) {
  EXPECT_EQ(run({"run", (folder_ / "none.toml").string()}), 3);
  EXPECT_THAT(err_, HasSubstr("none.toml: No such file"));
  EXPECT_EQ(run({"run", folder_.string()}), 3);
  EXPECT_EQ(run({"rum", study()}), 2);
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"run"}), 2);
  EXPECT_THAT(err_, HasSubstr("see isopatch run --help"));
  EXPECT_EQ(run({"run", study(), "--set", "load.0.tracton=1"}), 2);
  EXPECT_EQ(run_text(replaced(bar, "generate = \"box\"\nsize = [2, 1, 1]\npatches = [2, 1, 1]",
                              "file = \"none.xml\"")),
            3);
  EXPECT_THAT(err_, HasSubstr((folder_ / "none.xml").string()));
}

TEST_F(Program, MaterialsMustCoverEveryPatchOnce) {
  EXPECT_EQ(run_text(replaced(bar, "young = 1e9", "patches = 0\nyoung = 1e9")), 2);
  EXPECT_THAT(err_, HasSubstr("patch 1 has no material"));
  EXPECT_EQ(run_text(bar + "[[material]]\npatches = [1]\nname = \"steel\"\n"), 2);
  EXPECT_THAT(err_, HasSubstr("study.toml:19:1: patch 1 already has the material at "));
  EXPECT_THAT(err_, HasSubstr("study.toml:6:1"));
  EXPECT_EQ(run_text(replaced(bar, "young = 1e9", "patches = [0, 5]\nyoung = 1e9")), 2);
  EXPECT_THAT(err_, HasSubstr("patch 5 does not exist: the model has patches 0 to 1"));
}

TEST_F(Program, ConflictsOutsideProbesAndMissingDensitiesAreRefused) {
  EXPECT_EQ(run_text(bar + "[[support]]\nfaces = [\"x_min\"]\ndisplacement = [1, \"free\", \"free\"]\n"), 1);
  EXPECT_THAT(err_, HasSubstr("support 1 (guides)"));
  EXPECT_EQ(run_text(replaced(bar, "point = [2, 1, 1]", "point = [3, 1, 1]")), 2);
  EXPECT_THAT(err_, HasSubstr("outside the part"));
  EXPECT_EQ(run_text(bar + "[[load]]\ngravity = [0, 0, -9.81]\n"), 2);
  EXPECT_THAT(err_, HasSubstr("density"));
  EXPECT_EQ(run_text(replaced(bar, "faces = [\"x_max\"]", "faces = [\"x_mx\"]")), 2);
  EXPECT_THAT(err_, HasSubstr("did you mean"));
}

/// A cube whose corner (1, 1, 1) is moved to (t, t, t): det J there is 3 t - 2.
std::string cube_with_corner(double t) {
  return fmt::format(
      "700 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n{0} {0} {0}\n",
      t);
}

TEST_F(Program, AFoldBetweenGaussPointsIsAWarningAFoldAtOneAnError) {
  const std::string text = replaced(
      replaced(bar, "generate = \"box\"\nsize = [2, 1, 1]\npatches = [2, 1, 1]", "file = \"cube.g2\""),
      "faces = [\"x_min\", \"y_min\", \"z_min\"]", "faces = [\"0:west\", \"0:south\", \"0:front\"]");
  const std::string loaded = replaced(replaced(text, "faces = [\"x_max\"]", "faces = [\"0:back\"]"),
                                      "point = [2, 1, 1]", "point = [0, 0, 0]");
  write_file(folder_ / "cube.g2", cube_with_corner(0.6));
  EXPECT_EQ(run_text(loaded + "[discretization]\ndegree = 1\npoints = 2\n"), 0) << err_;
  EXPECT_THAT(err_, HasSubstr("isopatch: warning: patch 0 is folded at parameter (1, 1, 1), (600, 600, 600) "
                              "mm: its Jacobian determinant is -0.2 m^3"));
  EXPECT_THAT(json::parse(read_file(results() / "summary.json"))["model"]["patches_not_certified"],
              testing::ElementsAre(0));
  write_file(folder_ / "cube.g2", cube_with_corner(-0.2));
  EXPECT_EQ(run_text(loaded + "[discretization]\ndegree = 1\npoints = 2\n"), 2);
  EXPECT_THAT(err_, HasSubstr("isopatch: error: patch 0 is folded: det J = -"));
  // The first layer of Gauss points with a negative one names the worst of its line.
  EXPECT_THAT(err_, HasSubstr("at the Gauss point with parameter (0.788675, 0.211325, 0.788675), place"));
  EXPECT_EQ(run({"info", study()}), 2);
  EXPECT_THAT(err_, HasSubstr("Gauss points are negative too, so no study can run"));
  EXPECT_THAT(err_, HasSubstr("isopatch: error: patch 0 is folded: det J = -"));
}

TEST_F(Program, CompareSolvesBothWays) {
  ASSERT_EQ(run({"compare", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("the two couplings agree"));
  const json comparison = json::parse(read_file(results() / "compare.json"));
  EXPECT_EQ(comparison["agree"], true);
  EXPECT_EQ(comparison["lagrange"]["multipliers"], 27);
  EXPECT_LT(comparison["difference"]["displacement"], 1e-9);
  EXPECT_LT(comparison["difference"]["internal_energy"], 1e-9);
  EXPECT_LT(comparison["difference"]["multipliers"], 1e-8);
  EXPECT_EQ(comparison["difference"]["allowed"], 1e-9);
  EXPECT_EQ(comparison["difference"]["allowed_multipliers"], 1e-8);
}

TEST_F(Program, InfoDescribesStudiesAndResults) {
  ASSERT_EQ(run({"info", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("2 patches, 1 interface, 10 boundary faces, one body"));
  EXPECT_THAT(out_, HasSubstr("x_min"));
  ASSERT_EQ(run({"info", study(), "--json", "-q"}), 0);
  EXPECT_NEAR(json::parse(out_)["volume"], 2, 1e-13);
  ASSERT_EQ(run({"run", study(), "-q"}), 0);
  ASSERT_EQ(run({"info", (results() / "results.h5").string()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("internal energy 100 kJ"));
}

TEST_F(Program, ProbeAndFieldsWorkFromStoredResults) {
  ASSERT_EQ(run_text(bar, {"-q", "--set", "model.orientation_seed=3"}), 0) << err_;
  const std::string file = (results() / "results.h5").string();
  ASSERT_EQ(run({"probe", file, "--point", "2,1 m,500mm", "--json"}), 0) << err_;
  const json at_point = json::parse(out_);
  EXPECT_NEAR(at_point["displacement"][0], 0.02, 1e-13);
  const json& parameter = at_point["parameter"];
  const std::string text = parameter[0].dump() + "," + parameter[1].dump() + "," + parameter[2].dump();
  ASSERT_EQ(run({"probe", file, "--patch", at_point["patch"].dump(), "--parameter", text, "--json"}), 0)
      << err_;
  EXPECT_NEAR(json::parse(out_)["point"][0], 2, 1e-12);
  EXPECT_EQ(run({"probe", file, "--point", "9,9,9"}), 2);
  EXPECT_EQ(run({"probe", file}), 2);
  EXPECT_EQ(run({"probe", file, "--patch", "7", "--parameter", "0,0,0"}), 2);
  ASSERT_EQ(run({"fields", file, "-o", (folder_ / "again").string()}), 0) << err_;
  for (const char* name : {"results.vtm", "results_exact.vtm", "fields/patch_000.vtu", "fields/patch_001.vtu",
                           "fields/exact_patch_000.vtu", "fields/boundary_000.vtu"})
    EXPECT_EQ(read_file(folder_ / "again" / name), read_file(results() / name)) << name;
}

TEST_F(Program, ConvertKeepsTheModel) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0);
  const std::string source = (folder_ / "a.g2").string();
  write_file(source,
             "700 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n"
             "0 0 0\n2 0 0\n0 1 0\n2 1 0\n0 0 1\n2 0 1\n0 1 1\n2 1 1\n");
  const std::string target = (folder_ / "a.xml").string();
  ASSERT_EQ(run({"convert", source, "-o", target}), 0) << err_;
  ASSERT_EQ(run({"info", target, "--json", "--length-unit", "mm"}), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["volume"], 2e-9, 1e-22);
  EXPECT_EQ(run({"info", target, "--length-unit", "MPa"}), 2);
}

TEST_F(Program, HelpTeachesByExample) {
  ASSERT_EQ(run({"--help"}), 0);
  EXPECT_THAT(out_, HasSubstr("isopatch run examples/link/study.toml"));
  EXPECT_THAT(out_, HasSubstr("Exit codes"));
  for (const char* command : {"run", "compare", "info", "probe", "fields", "convert", "keys"}) {
    ASSERT_EQ(run({command, "--help"}), 0);
    EXPECT_THAT(out_, HasSubstr("isopatch " + std::string(command))) << command;
  }
  ASSERT_EQ(run({"--version"}), 0);
  EXPECT_THAT(out_, StartsWith("isopatch "));
  EXPECT_THAT(out_, HasSubstr("\nBLAS: "));
  ASSERT_EQ(run({"keys", "where"}), 0);
  EXPECT_THAT(out_, HasSubstr("cylinder"));
}

}  // namespace
}  // namespace isopatch::app
