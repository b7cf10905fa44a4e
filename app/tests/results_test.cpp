#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <fstream>

#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

/// What `info` tells of a file.
class Results : public Program {
 protected:
  json info(const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"info", file, "--json", "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments), 0) << err_;
    return json::parse(out_);
  }
  std::string file() const { return (results() / "results.h5").string(); }
  /// Bytes of all files below the results, by name.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> result;
    for (const std::string& name : files_below(results())) result[name] = read_file(results() / name);
    return result;
  }
};

TEST_F(Results, NameFacesAsTheStudyDoes) {
  int left_handed = 0;
  for (int seed = 0; seed < 6; ++seed) {
    const std::string set = fmt::format("model.orientation_seed={}", seed);
    const json model = info(study(), {"--set", set});
    ASSERT_EQ(run({"run", study(), "-q", "--set", set, "--set", "discretization.refine=1"}), 0) << err_;
    const json stored = info(file());
    ASSERT_EQ(stored["boundary_faces"].size(), model["boundary_faces"].size());
    for (std::size_t i = 0; i < model["boundary_faces"].size(); ++i) {
      const json& a = model["boundary_faces"][i];
      const json& b = stored["boundary_faces"][i];
      EXPECT_EQ(b["face"], a["face"]) << "seed " << seed;
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(b["centre"][d].get<double>(), a["centre"][d].get<double>(), 1e-14) << a["face"];
    }
    EXPECT_EQ(stored["boundaries"], model["boundaries"]);
    EXPECT_EQ(stored["interfaces"][0]["first"], model["interfaces"][0]["first"]);
    for (const json& patch : stored["patches"]) left_handed += patch["left_handed"].get<bool>();
  }
  EXPECT_GT(left_handed, 2) << "or nothing was tested";
}

TEST_F(Results, KeepGapsThatTheStudyAccepts) {
  const std::string cube = "700 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n";
  write_file(folder_ / "gap.g2", cube + "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n" + cube +
                                     "1.002 0 0 2 0 0 1.002 1 0 2 1 0 1.002 0 1 2 0 1 1.002 1 1 2 1 1\n");
  ASSERT_EQ(run_text(R"([model]
file = "gap.g2"
same_point = 2e-3
near_miss = 1e-2
[[material]]
name = "steel"
[[support]]
faces = ["0:west"]
displacement = [0, 0, 0]
[[load]]
faces = ["1:east"]
traction = ["1 MPa", 0, 0]
)"),
            0)
      << err_;
  EXPECT_EQ(info(file())["interfaces"].size(), 1u);
  EXPECT_NEAR(info(file())["interfaces"][0]["gap"].get<double>(), 2e-3, 1e-12);
}

TEST_F(Results, ASecondRunAtTheSameTimeIsRefused) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  const auto before = contents();
  const int directory = ::open(results().c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(directory, LOCK_EX), 0);
  const std::string taken = "another run writes to the output directory " + results().string();
  EXPECT_EQ(run({"run", study()}), 3);
  EXPECT_THAT(err_, HasSubstr(taken));
  EXPECT_THAT(err_, testing::Not(HasSubstr("reading the model"))) << "before any work";
  EXPECT_EQ(run({"compare", study()}), 3);
  EXPECT_THAT(err_, HasSubstr(taken));
  EXPECT_EQ(run({"fields", file(), "-o", results().string()}), 3);
  EXPECT_THAT(err_, HasSubstr(taken));
  EXPECT_EQ(contents(), before);
  ::close(directory);
  EXPECT_EQ(run({"run", study(), "-q"}), 0) << err_;
}

TEST_F(Results, ADirectoryThatARunMadeGoesWithItsFailure) {
  const fs::path deep = folder_ / "a/b/c";
  EXPECT_NE(run({"run", study(), "-o", deep.string(), "--set", "load.0.faces=[\"x_min\", \"0:east\"]"}), 0);
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

// The shell's file size limit stands for a full disk. Units are blocks of 512 bytes.
TEST_F(Results, AFullDiskKeepsTheEarlierOnesAndTheSolution) {
  ASSERT_EQ(run({"run", study(), "-q", "--set", "model.patches=[3,1,1]"}), 0) << err_;
  const auto before = contents();
  const std::string log = (folder_ / "log").string();
  const auto limited = [&](int blocks) {
    return shell(fmt::format("(ulimit -f {}; exec {} run {} -q --set discretization.refine=3) 2>{}", blocks,
                             ISOPATCH_PROGRAM, study(), log));
  };
  EXPECT_EQ(limited(8), 3) << "not even the solution fits";
  EXPECT_EQ(contents(), before);
  // The fields are larger than the solution.
  EXPECT_EQ(limited(400), 3);
  const std::string kept = (results() / "unfinished/results.h5").string();
  EXPECT_THAT(read_file(log), HasSubstr("The solution is kept in " + kept));
  ASSERT_EQ(run({"info", kept}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("internal energy 100 kJ"));
  auto now = contents();
  EXPECT_EQ(now.erase("unfinished/results.h5"), 1u);
  EXPECT_EQ(now, before);
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  EXPECT_FALSE(fs::exists(results() / "unfinished")) << "the next run that succeeds clears it";
}

TEST_F(Results, OutputThatIsFullIsAnError) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  const std::string log = (folder_ / "log").string();
  for (const std::string& command :
       {"info " + study() + " --json", "info " + file(), std::string("keys"), std::string("--help"),
        "run " + study(), "probe " + file() + " --point 1,1,1"}) {
    EXPECT_EQ(shell(fmt::format("{} {} >/dev/full 2>{}", ISOPATCH_PROGRAM, command, log)), 3) << command;
    EXPECT_THAT(read_file(log), HasSubstr("cannot write to standard output")) << command;
  }
}

TEST_F(Results, ChangedBytesAreNoticed) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  std::string bytes = read_file(file());
  const auto at = bytes.find("title = \"bar\"");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 9] = 'c';
  write_file(file(), bytes);
  EXPECT_EQ(run({"info", file()}), 2);
  EXPECT_THAT(err_, HasSubstr("results.h5: dataset '/study' is not as it was written"));
}

}  // namespace
}  // namespace isopatch::app
