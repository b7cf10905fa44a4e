// What a run says of its own accuracy, and how values at many places come out.

#include "app/run/extrapolation.hpp"
#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

TEST(Extrapolation, FindsTheLimitOfChangesThatShrink) {
  EXPECT_NEAR(extrapolated({9, 10 - 0.25, 10 - 0.0625}).value().limit, 10, 1e-12);
  EXPECT_NEAR(extrapolated({9, 10 - 0.25, 10 - 0.0625}).value().doubt, 0.0625, 1e-12);  // all that was added
  EXPECT_FALSE(extrapolated({9, 9.75}));
  EXPECT_FALSE(extrapolated({9, 9.1, 9.3}));
  EXPECT_FALSE(extrapolated({9, 9.1, 9}));
}

// Changes of 1 and 0.8 would lead to 5; those of a crack lead on by as much again.
TEST(Extrapolation, GoesNoFartherThanACrackAllowsAndSaysHowSureItIs) {
  EXPECT_NEAR(extrapolated({0, 1, 1.8}).value().limit, 1.8 + 0.8, 1e-12);
  const Extrapolation found = extrapolated({0, 1, 1.5, 1.7}).value();  // 2, then 1.7 + 0.2 * 0.4 / 0.6
  EXPECT_NEAR(found.limit, 1.7 + 0.2 * 2 / 3, 1e-12);
  EXPECT_NEAR(found.doubt, 2 - found.limit, 1e-12);
}

TEST(Extrapolation, TellsGrowthFromConvergence) {
  EXPECT_TRUE(grows({18, 23, 31}));
  EXPECT_FALSE(grows({18, 23, 24}));
  EXPECT_FALSE(grows({18, 23}));
  EXPECT_FALSE(grows({31, 23, 18}));
  EXPECT_FALSE(grows({18, 18.1, 18.2}));  // by half a percent
}

// An L-bracket: its re-entrant edge has stress without a limit.
const std::string bracket = R"([model]
generate = "bracket"
[discretization]
degree = 2
refine = 1
[[material]]
young = "200 GPa"
poisson = 0.3
[[support]]
faces = ["y_max"]
displacement = [0, 0, 0]
[[load]]
faces = ["x_max"]
traction = [0, "-1 MPa", 0]
[[probe]]
name = "leg"
point = [1.6, 0.3, 0.5]
[[probe]]
name = "edge"
point = [1, 1, 0.5]
)";

class Accuracy : public Program {
 protected:
  json summary() const { return json::parse(read_file(results() / "summary.json")); }
};

TEST_F(Accuracy, OfARunIsSaidEverywhere) {
  ASSERT_EQ(run_text(bracket), 0) << err_;
  const json error = summary()["results"]["discretization_error"];
  EXPECT_GT(error["energy_norm"], 0.05);
  EXPECT_LT(error["energy_norm"], 0.5);
  const double share = error["energy"].get<double>() / summary()["results"]["internal_energy"].get<double>();
  // The norm is relative to the solution's with the error's own energy.
  const double norm = error["energy_norm"];
  EXPECT_NEAR(norm * norm, share / (1 + share), 1e-6 * share);
  EXPECT_GT(summary()["probes"][0]["von_mises_error"], 0);
  EXPECT_FALSE(summary()["probes"][0].contains("singular"));
  EXPECT_EQ(summary()["probes"][1]["singular"], "a re-entrant edge of 270 degrees");
  EXPECT_EQ(error["singular"], "a re-entrant edge of 270 degrees");
  EXPECT_THAT(out_, HasSubstr("% in the energy norm"));
  EXPECT_THAT(out_, HasSubstr("with refinement: it is at a re-entrant edge of 270 degrees"));
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("\"stress_error\""));
  EXPECT_THAT(read_file(results() / "fields" / "patch_000.vtu"), HasSubstr("Name=\"error_energy\""));
}

// The elements' errors come back from the file.
TEST_F(Accuracy, IsKeptWithTheResults) {
  ASSERT_EQ(run_text(bracket), 0) << err_;
  const std::string first = read_file(results() / "fields" / "patch_001.vtu");
  const std::string again = (folder_ / "again").string();
  ASSERT_EQ(run({"fields", (results() / "results.h5").string(), "-o", again}), 0) << err_;
  EXPECT_EQ(read_file(folder_ / "again" / "fields" / "patch_001.vtu"), first);
}

TEST_F(Accuracy, IsNotEstimatedIfNotAskedFor) {
  ASSERT_EQ(run_text(bracket + "[output]\nerror_estimate = false\n"), 0) << err_;
  EXPECT_TRUE(summary()["results"]["discretization_error"].is_null());
  EXPECT_FALSE(summary()["probes"][0].contains("von_mises_error"));
  EXPECT_THAT(out_, testing::Not(HasSubstr("energy norm")));
  EXPECT_THAT(read_file(results() / "fields" / "patch_000.vtu"), testing::Not(HasSubstr("error_energy")));
}

TEST_F(Accuracy, OfLevelsIsATable) {
  ASSERT_EQ(run_text(bracket, {"--levels", "3", "--set", "discretization.refine=0"}), 0) << err_;
  const json levels = summary()["levels"];
  ASSERT_EQ(levels.size(), 3);
  EXPECT_EQ(levels[2]["refine"], 2);
  EXPECT_EQ(levels[2]["internal_energy"], summary()["results"]["internal_energy"]);
  EXPECT_LT(levels[2]["energy_norm_error"], levels[1]["energy_norm_error"]);
  EXPECT_GT(summary()["convergence"]["extrapolated_energy"], levels[2]["internal_energy"]);
  EXPECT_THAT(out_, HasSubstr("error in energy norm"));
  EXPECT_THAT(out_, HasSubstr("limit of the energy"));
  EXPECT_THAT(out_, HasSubstr("%, give or take "));
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("Error of the discretization"));
}

// Iterations grow with refinement: 76 for the first level, 101 for the next.
TEST_F(Accuracy, OfALevelIsNotLostWithTheNext) {
  EXPECT_EQ(
      run_text(bracket, {"--levels", "3", "--set", "discretization.refine=0", "--set", "solver.method=cg",
                         "--set", "solver.preconditioner=block_jacobi", "--set", "solver.max_iterations=88"}),
      1);
  EXPECT_EQ(summary()["levels"].size(), 1);
  EXPECT_EQ(summary()["levels"][0]["internal_energy"], summary()["results"]["internal_energy"]);
}

TEST_F(Accuracy, IsReachedWhereItIsAskedFor) {
  ASSERT_EQ(run_text(bracket, {"--set", "accuracy.energy='6 %'"}), 0) << err_;
  const json found = summary();
  EXPECT_LE(found["results"]["discretization_error"]["energy_norm"], 0.06);
  EXPECT_TRUE(found["accuracy"]["reached"]);
  EXPECT_EQ(found["accuracy"]["energy"], 0.06);
  const json levels = found["levels"];
  ASSERT_GT(levels.size(), 1);
  EXPECT_GT(levels[levels.size() - 2]["energy_norm_error"], 0.06);
  EXPECT_EQ(levels.back()["dofs"], found["discretization"]["dofs"]);
  EXPECT_TRUE(found["convergence"]["extrapolated_energy"].is_null());
  EXPECT_THAT(out_, HasSubstr("6 % in the energy norm asked: reached"));
  EXPECT_THAT(out_, HasSubstr("step     unknowns"));
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("6 % in the energy norm asked: reached"));
  // The report is the same from the file.
  const std::string page = read_file(results() / "report.html");
  ASSERT_EQ(run({"report", (results() / "results.h5").string()}), 0) << err_;
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("6 % in the energy norm asked: reached"));
}

TEST_F(Accuracy, OfAStressIsThatAtItsProbe) {
  ASSERT_EQ(run_text(bracket, {"--set", "accuracy={ stress = '3 %', probe = 'leg' }"}), 0) << err_;
  const json leg = summary()["probes"][0];
  EXPECT_LE(leg["von_mises_error"].get<double>(), 0.03 * leg["von_mises"].get<double>());
  EXPECT_GT(summary()["levels"].size(), 1);
}

TEST_F(Accuracy, ThatIsNotReachedSaysWhy) {
  ASSERT_EQ(run_text(bracket, {"--set", "accuracy={ energy = 0.01, refinements = 1 }"}), 0) << err_;
  EXPECT_FALSE(summary()["accuracy"]["reached"]);
  EXPECT_EQ(summary()["levels"].size(), 2);
  EXPECT_THAT(err_, HasSubstr("the accuracy that is asked for is not reached: accuracy.refinements is 1"));
  ASSERT_EQ(run_text(bracket, {"--set", "accuracy.stress='1 %'"}), 0) << err_;
  EXPECT_THAT(err_,
              HasSubstr("the stress there grows with every refinement: a re-entrant edge of 270 degrees"));
  EXPECT_EQ(summary()["levels"].size(), 1);
}

// With the load of one case alone the error is smaller than with that of the other.
TEST_F(Accuracy, IsThatOfTheWorstCase) {
  const std::string cases = bracket + R"([[load]]
name = "along"
case = "pull"
faces = ["x_max"]
traction = ["1 MPa", 0, 0]
)";
  ASSERT_EQ(run_text(cases, {"--set", "load.0.case=push", "--set", "accuracy.energy='8 %'"}), 0) << err_;
  const json found = summary();
  ASSERT_EQ(found["cases"].size(), 2);
  for (const json& one : found["cases"]) {
    const std::string name = one["name"];
    EXPECT_LE(one["results"]["discretization_error"]["energy_norm"], 0.08);
    // The levels of a case are its own, in the text and on its page.
    ASSERT_EQ(one["levels"].size(), found["levels"].size());
    EXPECT_EQ(one["levels"].back()["energy_norm_error"],
              one["results"]["discretization_error"]["energy_norm"]);
    EXPECT_EQ(one["levels"].back()["max_von_mises"], one["results"]["max_von_mises"]);
    EXPECT_THAT(out_, HasSubstr("levels of case " + name + "\n"));
    const std::string page = read_file(results() / "cases" / name / "report.html");
    EXPECT_THAT(page, HasSubstr("\"internal_energy\": " + one["levels"][0]["internal_energy"].dump()));
    EXPECT_THAT(page, HasSubstr(">asked for"));
  }
  EXPECT_EQ(found["levels"], found["cases"][0]["levels"]);
}

TEST_F(Accuracy, NeedsAGoalThatMakesSense) {
  const auto refused = [&](const std::string& set, const std::string& why) {
    EXPECT_EQ(run_text(bracket, {"--set", set}), 2) << set;
    EXPECT_THAT(err_, HasSubstr(why)) << set;
  };
  refused("accuracy={ refinements = 2 }", "[accuracy] needs energy or stress");
  refused("accuracy={ energy = 0.1, probe = 'leg' }", "accuracy.stress is missing");
  refused("accuracy={ stress = 0.1, probe = 'arm' }", "no [[probe]] has that name");
  refused("accuracy.energy='120 %'", "energy");
  EXPECT_EQ(run_text(bracket + "[accuracy]\nenergy = 0.1\n[output]\nerror_estimate = false\n"), 2);
  EXPECT_THAT(err_, HasSubstr("by the error estimate, which output.error_estimate = false leaves out"));
  EXPECT_EQ(run_text(bracket, {"--set", "accuracy.energy=0.1", "--levels", "2"}), 2);
  EXPECT_THAT(err_, HasSubstr("leave one away"));
}

// Under a point the energy has no limit, and every refinement shows more of it.
TEST_F(Accuracy, ThatNoRefinementBringsEndsTheRun) {
  ASSERT_EQ(run_text(bracket, {"--set", "load=[{ points = [[2, 0.5, 0.5]], force = [0, '1 kN', 0] }]",
                               "--set", "accuracy.energy='1 %'"}),
            0)
      << err_;
  EXPECT_FALSE(summary()["accuracy"]["reached"]);
  EXPECT_THAT(err_, HasSubstr("two refinements have not made the error smaller"));
  EXPECT_LT(summary()["levels"].size(), 6);
}

// A stress is held against that of the solution before.
TEST_F(Accuracy, OfAStressIsNoBetterThanItsLastChange) {
  ASSERT_EQ(run_text(bracket, {"--set", "accuracy={ stress = '3 %', probe = 'leg' }"}), 0) << err_;
  EXPECT_TRUE(summary()["accuracy"]["reached"]);
  const json timings = summary()["timings"];
  EXPECT_GT(timings["coarser levels"], 0);
  EXPECT_GT(timings["total"], timings["coarser levels"]);
}

// The leg with the support is finer than the others, which follow or are coupled as they are.
TEST_F(Accuracy, OfPatchesOfTheirOwn) {
  const std::string fine = bracket + "[[discretization.patch]]\npatches = [1]\nrefine = 1\n";
  ASSERT_EQ(run_text(fine), 0) << err_;
  const json followed = summary();
  ASSERT_EQ(run({"info", study(), "--set", "coupling.non_matching=nitsche"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("faces that will not match: 0:"));
  ASSERT_EQ(run({"info", study(), "--json", "--set", "coupling.non_matching=nitsche"}), 0) << err_;
  EXPECT_FALSE(json::parse(out_)["non_matching"].empty());
  ASSERT_EQ(run_text(fine, {"--set", "coupling.non_matching=nitsche"}), 0) << err_;
  const json coupled = summary();
  EXPECT_EQ(followed["model"]["non_matching_interfaces"], 0);
  EXPECT_GT(coupled["model"]["non_matching_interfaces"], 0);
  EXPECT_EQ(coupled["model"]["non_matching"].size(), coupled["model"]["non_matching_interfaces"]);
  EXPECT_LT(coupled["discretization"]["dofs"], followed["discretization"]["dofs"]);
  const double difference = coupled["results"]["internal_energy"].get<double>() /
                                followed["results"]["internal_energy"].get<double>() -
                            1;
  EXPECT_LT(std::abs(difference), 0.01);
  ASSERT_EQ(run({"report", (results() / "results.h5").string()}), 0) << err_;
  ASSERT_EQ(run({"info", (results() / "results.h5").string()}), 0) << err_;
  // The same patch by a place in it, and a place where there is none.
  const auto by_part = [](const std::string& centre) {
    return bracket + "[[discretization.patch]]\npart = { sphere = { centre = " + centre +
           ", radius = 0.1 } }\nrefine = 1\n";
  };
  ASSERT_EQ(run_text(by_part("[1.5, 0.5, 0.5]"), {"--set", "coupling.non_matching=nitsche"}), 0) << err_;
  EXPECT_EQ(summary()["discretization"]["dofs"], coupled["discretization"]["dofs"]);
  EXPECT_EQ(run_text(by_part("[9, 9, 9]")), 2);
  EXPECT_THAT(err_, HasSubstr("no patch reaches into the part of [[discretization.patch]]"));
  // Refined where it is needed, patch by patch.
  ASSERT_EQ(run_text(bracket, {"--set", "coupling.non_matching=nitsche", "--set", "accuracy.energy='6 %'"}),
            0)
      << err_;
  EXPECT_TRUE(summary()["accuracy"]["reached"]);
  EXPECT_GT(summary()["model"]["non_matching_interfaces"], 0);
}

TEST_F(Accuracy, PatchesThatAskForLessThanAllSaySo) {
  const auto warns = [&](const std::string& keys) {
    EXPECT_EQ(run_text(bracket + "[[discretization.patch]]\npatches = [1]\n" + keys,
                       {"--set", "discretization.max_size=0.5"}),
              0)
        << err_;
    return err_.find("of [[discretization.patch]] is ") != std::string::npos;
  };
  EXPECT_TRUE(warns("degree = 1\n"));
  EXPECT_THAT(err_, HasSubstr("study.toml:21:1: degree of [[discretization.patch]] is lower than that of"));
  EXPECT_TRUE(warns("max_size = 0.7\n"));
  EXPECT_FALSE(warns("degree = 2\nmax_size = 0.4\n"));
}

// Two cubes of different materials pulled along x; transverse stresses differ where they meet.
const std::string two_materials = R"([model]
generate = "box"
patches = [2, 1, 1]
size = [2, 1, 1]
[discretization]
degree = 2
[[material]]
name = "soft"
patches = [0]
young = "1 GPa"
poisson = 0.3
[[material]]
name = "hard, grey"
patches = [1]
young = "200 GPa"
poisson = 0.3
[[support]]
faces = ["x_min"]
displacement = [0, 0, 0]
[[load]]
faces = ["x_max"]
traction = ["1 MPa", 0, 0]
[[probe]]
name = "joint"
point = [1, 0.5, 0.5]
)";

TEST_F(Accuracy, ProbesHaveBothSidesOfMaterials) {
  ASSERT_EQ(run_text(two_materials), 0) << err_;
  const json probe = summary()["probes"][0];
  ASSERT_EQ(probe["sides"].size(), 1);
  EXPECT_NE(probe["sides"][0]["patch"], probe["patch"]);
  EXPECT_EQ(probe["sides"][0]["material"], "hard, grey");
  EXPECT_GT(std::abs(probe["sides"][0]["stress"][1].get<double>() - probe["stress"][1].get<double>()), 1e4);
}

TEST_F(Accuracy, ValuesAlongALineAreCsv) {
  ASSERT_EQ(run_text(two_materials), 0) << err_;
  const std::string file = (results() / "results.h5").string();
  ASSERT_EQ(run({"probe", file, "--line", "0,.5,.5", "2,.5,.5", "--count", "3"}), 0) << err_;
  std::istringstream lines(out_);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 5) << out_;  // a heading, and two rows for the middle
  EXPECT_THAT(rows[0], StartsWith("place,x,y,z,distance,patch,material,u_x"));
  EXPECT_THAT(rows[2], StartsWith("2,1,0.5,0.5,1,0,soft,"));
  EXPECT_THAT(rows[3], StartsWith("2,1,0.5,0.5,1,1,\"hard, grey\","));
  EXPECT_EQ(run({"probe", file, "--line", "0,0,0", "1,0,0", "--point", "0,0,0"}), 2);
}

TEST_F(Accuracy, ValuesOverAListOfPlacesAreCsv) {
  ASSERT_EQ(run_text(two_materials), 0) << err_;
  const std::string file = (results() / "results.h5").string();
  const std::string places = (folder_ / "places.csv").string();
  write_file(places, "x,y,z\n# by hand\n.5,.5,.5\r\n\n500 mm,.5,.5\n9,9,9\n");
  ASSERT_EQ(run({"probe", file, "--places", places}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("\n1,0.5,0.5,0.5,0,0,soft,"));
  EXPECT_THAT(out_, HasSubstr("\n2,0.5,0.5,0.5,0,0,soft,"));
  EXPECT_THAT(out_, HasSubstr(",,,,,,,,,,,\n"));
  write_file(places, ".5,.5,.5\n1,2\n");
  EXPECT_EQ(run({"probe", file, "--places", places}), 2);
  EXPECT_THAT(err_, HasSubstr("places.csv:2: expected three values"));
}

}  // namespace
}  // namespace isopatch::app
