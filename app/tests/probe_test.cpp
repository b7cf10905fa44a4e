// What `isopatch probe` refuses, and how it says so.
#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

class Probe : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    ASSERT_EQ(run({"run", study(), "-q", "--set", "output.report=false", "--set", "output.fields=false"}), 0)
        << err_;
  }
  std::string file() const { return (results() / "results.h5").string(); }
  void refused(std::vector<std::string> options, const std::string& words, int code = 2) {
    options.insert(options.begin(), {"probe", file()});
    EXPECT_EQ(run(options), code) << words;
    EXPECT_THAT(err_, HasSubstr(words));
    EXPECT_EQ(out_, "") << words;
  }
};

TEST_F(Probe, NeedsOnePlaceSaidInOneWay) {
  const std::string ways =
      "give either --point X,Y,Z, or --patch N with --parameter A,B,C, or --line, or --places";
  refused({}, ways);
  refused({"--point", "0,0,0", "--patch", "0", "--parameter", "0,0,0"}, ways);
  refused({"--patch", "0"}, ways);
  refused({"--parameter", "0,0,0"}, ways);
  refused({"--line", "0,0,0", "1,0,0", "--json"}, "--line and --places print CSV");
  refused({"--line", "0,0,0", "1,0,0", "--patch", "0"}, "--line and --places print CSV");
  refused({"--line", "0,0,0", "1,0,0", "--places", "p.csv"}, "--line and --places print CSV");
  refused({"--line", "0,0,0", "1,0,0", "--count", "1"}, "--count");
}

TEST_F(Probe, PlacesAndParametersAreThreeNumbers) {
  refused({"--point", "0,0"}, "expected three values");
  refused({"--point", "0,0,x"}, "'x'");
  refused({"--point", "0,0,1 kg"}, "kg");
  refused({"--patch", "0", "--parameter", "0,0"}, "expected three");
  refused({"--patch", "0", "--parameter", "0,0,1.5"}, "the parameter lies outside the knots of patch 0");
  refused({"--patch", "2", "--parameter", "0,0,0"}, "patch 2 does not exist: there are patches 0 to 1");
}

TEST_F(Probe, ListsOfPlacesHaveSome) {
  const std::string places = (folder_ / "places.csv").string();
  refused({"--places", places}, "cannot read " + places, 3);
  write_file(places, "x,y,z\n# none yet\n\n");
  refused({"--places", places}, places + " has no place X,Y,Z");
  write_file(places, "x,y,z\n0,0,0\n0,0,one\n");
  refused({"--places", places}, places + ":3: ");
}

TEST_F(Probe, CasesAreThoseOfTheResults) {
  refused({"--point", "1,1,1", "--case", "worst"}, file() + " has no load cases, so none named 'worst'");
}

}  // namespace
}  // namespace isopatch::app
