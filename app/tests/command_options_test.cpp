// Options of commands reach the work that they are about, and values that cannot be meant are refused.
#include <fmt/format.h>

#include "app/tests/program_fixture.hpp"
#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::app {
namespace {

class CommandOptions : public Program {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  static std::string solid(const std::string& name) { return geometry::test::made_solid(name).string(); }
};

TEST_F(CommandOptions, RoundsAreTakenOffWhereSegmentIsAskedTo) {
  ASSERT_EQ(run({"segment", solid("rounded_boss"), "-o", file("removed"), "--blends", "remove", "--json"}), 0)
      << err_;
  EXPECT_THAT(json::parse(out_)["bodies"][0]["blends"].get<std::string>(), HasSubstr("8 rounds of 0.001 m"));
  EXPECT_THAT(err_, HasSubstr("warning: solid 'rounded_boss': 8 rounds"));
  EXPECT_EQ(run({"segment", solid("rounded_boss"), "-o", file("other"), "--blends", "of"}), 2);
  EXPECT_THAT(err_, HasSubstr("--blends: of not in {keep,remove}"));
}

TEST_F(CommandOptions, LimitsHoldForWhatReadsCadFiles) {
  EXPECT_EQ(run({"info", solid("block"), "--cad-time-limit", "1e-3"}), 2);
  EXPECT_THAT(err_, HasSubstr("was stopped after 0.001 s"));
#if !defined(__SANITIZE_ADDRESS__)
  EXPECT_EQ(run({"info", solid("block"), "--cad-memory-limit", "5e7"}), 2);
  EXPECT_THAT(err_, HasSubstr("needed more than 0.05 GB of memory"));
  EXPECT_EQ(run({"info", solid("block"), "--cad-memory-limit", "1e6"}), 2);
  EXPECT_THAT(err_,
              HasSubstr("the memory limit for CAD files is 1000000 bytes; it must be 50000000 or more"));
#endif
  for (const char* value : {"0", "-1", "nan", "inf", "much"})
    for (const char* option : {"--cad-time-limit", "--cad-memory-limit"}) {
      EXPECT_EQ(run({"info", solid("block"), std::string(option) + "=" + value}), 2) << option << value;
      EXPECT_THAT(err_, HasSubstr(std::string(option) + ": '" + value + "' is no number above 0"));
    }
}

TEST_F(CommandOptions, TimeLimitsHoldForCutsAndReconstruction) {
  write_file(
      file("l.off"),
      "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
      "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 "
      "11\n");
  EXPECT_EQ(run({"segment", file("l.off"), "-o", file("blocks"), "--method", "cuts", "--time-limit", "1e-9"}),
            2);
  EXPECT_THAT(err_, HasSubstr("Raise time_limit"));
  EXPECT_EQ(run({"segment", file("l.off"), "-o", file("blocks"), "--time-limit", "0"}), 2);
  EXPECT_THAT(err_, HasSubstr("--time-limit: '0' is no number above 0"));
  EXPECT_EQ(run({"reconstruct", file("l.off"), "-o", file("solid"), "--time-limit", "0"}), 2);
  EXPECT_THAT(err_, HasSubstr("time_limit is 0; its range is (0, 1e7] seconds"));
}

TEST_F(CommandOptions, FilesOfBlocksAreDescribedInTextAlone) {
  ASSERT_EQ(run({"segment", solid("block"), "-o", file("blocks")}), 0) << err_;
  ASSERT_EQ(run({"info", file("blocks/blocks.h5")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("blocks.h5: 1 block\n"));
  EXPECT_EQ(run({"info", file("blocks/blocks.h5"), "--json"}), 2);
  EXPECT_THAT(err_, HasSubstr("--json describes patches, solids and studies, not files of blocks"));
}

TEST_F(CommandOptions, PairsSayHowBlocksMeet) {
  const auto box = [](double from, double to) {
    return fmt::format(
        "OFF\n8 6 0\n{0} 0 0\n{1} 0 0\n{1} 1 0\n{0} 1 0\n{0} 0 1\n{1} 0 1\n{1} 1 1\n{0} 1 1\n"
        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
        from, to);
  };
  write_file(file("a.off"), box(0, 1));
  write_file(file("b.off"), box(1, 2));
  write_file(file("pairs.txt"), "a 3 b 5\n");
  const auto parameterized = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"parameterize", file("a.off"), file("b.off"), "-o", file("p.xml")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  ASSERT_EQ(parameterized({"--pairs", file("pairs.txt")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("2 patches, 1 interface"));
  write_file(file("pairs.txt"), "a 3 b 3\n");
  EXPECT_EQ(parameterized({"--pairs", file("pairs.txt")}), 2);
  EXPECT_THAT(err_, HasSubstr("pair 0: faces a:face 3 and b:face 3 do not meet"));
  EXPECT_EQ(parameterized({"--pairs", file("none.txt")}), 3);
  EXPECT_THAT(err_, HasSubstr("none.txt"));
}

TEST_F(CommandOptions, PiecesSayHowFineFieldsAre) {
  ASSERT_EQ(run({"run", study(), "-q", "--set", "output.report=false"}), 0) << err_;
  const auto size = [&](const std::string& pieces) {
    EXPECT_EQ(run({"fields", (results() / "results.h5").string(), "-o", file(pieces), "--pieces", pieces}), 0)
        << err_;
    return static_cast<double>(fs::file_size(folder_ / pieces / "fields/patch_000.vtu"));
  };
  // Of 3^3 and 9^3 nodes.
  EXPECT_GT(size("8"), 10 * size("2"));
  EXPECT_EQ(run({"fields", (results() / "results.h5").string(), "-o", file("0"), "--pieces", "0"}), 2);
  EXPECT_THAT(err_, HasSubstr("--pieces: Value 0 not in range 1 to 32"));
}

}  // namespace
}  // namespace isopatch::app
