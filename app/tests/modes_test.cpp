#include <fmt/format.h>

#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

const std::string heavy_bar = bar + "[discretization]\ndegree = 2\n[modes]\nnumber = 3\n";

class Modes : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(study(), replaced(heavy_bar, "poisson = 0.25", "poisson = 0.25\ndensity = 1000"));
  }
  fs::path shape(int number) const { return results() / "modes" / std::to_string(number); }
};

TEST_F(Modes, AreWrittenWithTheirShapes) {
  ASSERT_EQ(run({"modes", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("modes.json, modes/1/results.vtm"));
  const json found = json::parse(read_file(results() / "modes.json"));
  EXPECT_EQ(found["modes"].size(), 3u);
  EXPECT_TRUE(found["warnings"].empty());
  for (int number = 1; number <= 3; ++number) EXPECT_TRUE(fs::exists(shape(number) / "results.vtm"));
  EXPECT_FALSE(fs::exists(results() / "unfinished_modes"));
}

TEST_F(Modes, OfAnEarlierRunDoNotStayBesideThoseOfTheLast) {
  ASSERT_EQ(run({"modes", study(), "-q"}), 0) << err_;
  fs::create_directories(results() / "modes" / "mine");
  ASSERT_EQ(run({"modes", study(), "-q", "--set", "modes.number=1"}), 0) << err_;
  EXPECT_TRUE(fs::exists(shape(1) / "results.vtm"));
  EXPECT_FALSE(fs::exists(shape(2)));
  EXPECT_TRUE(fs::exists(results() / "modes" / "mine"));
}

// The shell's file size limit stands for a full disk. Units are blocks of 512 bytes.
TEST_F(Modes, OfAnEarlierRunStayWholeWhereTheDiskIsFull) {
  ASSERT_EQ(run({"modes", study(), "-q"}), 0) << err_;
  const std::string before = read_file(results() / "modes.json");
  const std::string log = (folder_ / "log").string();
  EXPECT_EQ(
      shell(fmt::format("(ulimit -f 40; exec {} modes {} -q --set output.pieces=8 --set modes.number=1) 2>{}",
                        ISOPATCH_PROGRAM, study(), log)),
      3);
  EXPECT_EQ(read_file(results() / "modes.json"), before);
  EXPECT_TRUE(fs::exists(shape(3) / "results.vtm"));
  const fs::path kept = results() / "unfinished_modes" / "modes.json";
  EXPECT_THAT(read_file(log), HasSubstr("The frequencies are kept in " + kept.string()));
  EXPECT_EQ(json::parse(read_file(kept))["modes"].size(), 1u);
}

// What is killed leaves the file that it was writing.
TEST_F(Modes, AndRunsForgetWhatWasKilledAmidAFile) {
  const fs::path of_modes = results() / "unfinished_modes/modes/7/fields";
  const fs::path of_run = results() / "unfinished/cases/old/fields";
  fs::create_directories(of_modes);
  fs::create_directories(of_run);
  write_file(of_modes / "patch_000.vtu.unfinished", "half");
  write_file(of_run / "patch_000.vtu.unfinished", "half");
  write_file(results() / "unfinished/results.h5.unfinished", "half");
  ASSERT_EQ(run({"modes", study(), "-q"}), 0) << err_;
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  for (const std::string& name : files_below(results()))
    EXPECT_THAT(name, testing::Not(HasSubstr("unfinished")));
  EXPECT_FALSE(fs::exists(shape(7)));
  EXPECT_FALSE(fs::exists(results() / "cases"));
}

TEST_F(Modes, TakeNoMoreThanTheLimitOnMemory) {
  // The process holds more than that before it begins.
  EXPECT_EQ(
      run({"modes", study(), "--set", "solver.memory_limit='1 MB'", "--set", "discretization.refine=0"}), 1);
  EXPECT_THAT(err_, HasSubstr("[solver] memory_limit"));
  EXPECT_THAT(err_, HasSubstr("natural modes need factors, for which there is no memory"));
  // Ways to solve that modes do not use are no obstacle.
  EXPECT_EQ(
      run({"modes", study(), "-q", "--set", "coupling.method=lagrange", "--set", "solver.method=minres"}), 0)
      << err_;
}

}  // namespace
}  // namespace isopatch::app
