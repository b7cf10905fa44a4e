#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "app/reports/comparison_plots.hpp"
#include "app/reports/comparison_report.hpp"
#include "app/run/compare_levels.hpp"
#include "app/tests/program_fixture.hpp"
#include "solvers/memory.hpp"

namespace isopatch::app {
namespace {

using testing::ElementsAre;

json compared(const fs::path& results) {
  return json::parse(read_file(results / "compare.json"));
}

TEST_F(Program, CompareSaysWhereTheCouplingsDifferMost) {
  ASSERT_EQ(
      run({"compare", study(), "--set", "model.orientation_seed=3", "--set", "discretization.degree=2"}), 0)
      << err_;
  const json difference = compared(results())["difference"];
  for (const std::string what : {"max_displacement", "max_von_mises"}) {
    EXPECT_LT(difference[what], what == "max_von_mises" ? 1e-2 : 1e-9) << what;  // of 10 MPa and 20 mm
    EXPECT_GT(difference[what], 0) << what;
    const json at = difference[what + "_at"];
    std::string parameter;
    for (const json& value : at["parameter"])
      parameter += fmt::format("{}{}", parameter.empty() ? "" : ",", value.get<double>());
    ASSERT_EQ(run({"run", study(), "-q", "--set", "model.orientation_seed=3"}), 0) << err_;
    ASSERT_EQ(run({"probe", (results() / "results.h5").string(), "--json", "--patch",
                   std::to_string(at["patch"].get<int>()), "--parameter", parameter}),
              0)
        << err_;
    const json place = json::parse(out_)["point"];
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(place[i], difference[what + "_point"][i].get<double>(), 1e-12) << what;
  }
}

TEST_F(Program, CompareWritesTheForceOfEachInterface) {
  ASSERT_EQ(run({"compare", study()}), 0) << err_;
  const json interfaces = compared(results())["interfaces"];
  ASSERT_EQ(interfaces.size(), 1);
  EXPECT_EQ(interfaces[0]["first"], "0:east");
  EXPECT_EQ(interfaces[0]["second"], "1:west");
  EXPECT_NEAR(interfaces[0]["area"], 1, 1e-12);
  EXPECT_NEAR(interfaces[0]["force"][0], 1e7, 1e-2);  // the second patch pulls the first along x
  EXPECT_NEAR(interfaces[0]["force"][1], 0, 1e-2);
}

TEST_F(Program, CompareGoesThroughLevels) {
  ASSERT_EQ(
      run({"compare", study(), "--levels", "2", "--degrees", "1,2", "--set", "discretization.refine=1"}), 0)
      << err_;
  const json all = compared(results());
  ASSERT_EQ(all["levels"].size(), 4);
  std::vector<int> refines;
  std::vector<int> degrees;
  for (const json& level : all["levels"]) {
    refines.push_back(level["refine"]);
    degrees.push_back(level["degree"][0]);
    EXPECT_EQ(level["agree"], true);
  }
  EXPECT_THAT(refines, ElementsAre(1, 2, 1, 2));
  EXPECT_THAT(degrees, ElementsAre(1, 1, 2, 2));
  EXPECT_LT(all["levels"][0]["elimination"]["dofs"], all["levels"][1]["elimination"]["dofs"]);
  for (const char* key : {"refine", "degree", "elimination", "lagrange", "difference", "agree"})
    EXPECT_EQ(all[key], all["levels"][3][key]) << key;
  EXPECT_THAT(out_,
              HasSubstr("difference in displacement, energy, multipliers\n       1      1  elimination"));
}

TEST_F(Program, CompareOfOnePatchHasNothingToCouple) {
  ASSERT_EQ(run({"compare", study(), "--set", "model.patches=[1,1,1]"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("there is nothing to couple"));
  EXPECT_THAT(out_, testing::Not(HasSubstr("agree")));
  const json all = compared(results());
  EXPECT_EQ(all["coupled"], false);
  EXPECT_EQ(all["agree"], true);
}

TEST_F(Program, CompareHalvesElementsWhateverKeyMadeThem) {
  ASSERT_EQ(
      run({"compare", study(), "--levels", "2", "--set", "discretization.elements_per_direction=[4,1,1]"}), 0)
      << err_;
  const json levels = compared(results())["levels"];
  EXPECT_EQ(levels[0]["elements"], 2 * 4);
  EXPECT_EQ(levels[1]["elements"], 2 * 4 * 8);
}

TEST_F(Program, CompareEstimatesConditionsWhereItFactorizes) {
  ASSERT_EQ(run({"compare", study(), "--condition"}), 0) << err_;
  EXPECT_THAT(out_, testing::ContainsRegex("iterations +none +none"));  // of factorizations
  EXPECT_THAT(out_, HasSubstr("condition"));
  const json direct = compared(results());
  EXPECT_GT(direct["elimination"]["condition"], 2);
  EXPECT_GT(direct["lagrange"]["condition"], 2);
  ASSERT_EQ(run({"compare", study()}), 0) << err_;
  EXPECT_TRUE(compared(results())["lagrange"]["condition"].is_null());
  ASSERT_EQ(run({"compare", study(), "--condition", "--set", "solver.method=cg"}), 0) << err_;
  EXPECT_TRUE(compared(results())["elimination"]["condition"].is_null());
}

TEST_F(Program, CompareKeepsWhatIsFinishedWhenMemoryEnds) {
  const std::string memory_limit = fmt::format("solver.memory_limit={}", 120e6 + solvers::resident_memory());
  EXPECT_EQ(run({"compare", study(), "--levels", "6", "--set", memory_limit}), 1);
  EXPECT_THAT(err_, HasSubstr("isopatch: error: no memory for refine = "));
  const std::size_t finished = compared(results())["levels"].size();
  EXPECT_GE(finished, 1);
  EXPECT_LT(finished, 6);
  EXPECT_THAT(out_, HasSubstr("the two couplings agree"));
}

// Two blocks side by side that are pulled along their interface and do not shrink across: nothing is handed
// over.
TEST_F(Program, CompareDoesNotTakeRoundOffForADisagreement) {
  write_file(folder_ / "side.toml", R"([model]
generate = "box"
patches = [1, 2, 1]
[discretization]
degree = 2
refine = 1
[[material]]
young = "200 GPa"
poisson = 0
[[support]]
faces = ["x_min"]
displacement = [0, 0, 0]
[[load]]
faces = ["x_max"]
traction = ["1 MPa", 0, 0]
)");
  EXPECT_EQ(run({"compare", (folder_ / "side.toml").string(), "--output", results().string()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("the two couplings agree"));
}

// Whatever the size: a comparison of factors must not turn into one of a factor and an iteration.
TEST_F(Program, CompareFactorizesWithBothCouplingsWhereCholmodIsAskedFor) {
  ASSERT_EQ(run({"compare", study(), "--set", "solver.method=cholmod"}), 0) << err_;
  const json all = compared(results());
  EXPECT_EQ(all["elimination"]["method"], "cholmod");
  EXPECT_EQ(all["lagrange"]["method"], "mumps");
  EXPECT_EQ(all["lagrange"]["reason"], "asked for by name");
}

TEST_F(Program, CompareIteratesWithBothCouplingsAndPlotsTheResiduals) {
  ASSERT_EQ(run({"compare", study(), "--set", "solver.method=\"cg\"", "--set", "discretization.refine=3"}), 0)
      << err_;
  const json all = compared(results());
  EXPECT_EQ(all["elimination"]["method"], "cg");
  EXPECT_EQ(all["lagrange"]["method"], "minres");
  EXPECT_GT(all["lagrange"]["residual_history"].size(), 3);
  EXPECT_EQ(all["lagrange"]["residual_history"].size(), all["lagrange"]["iterations"].get<std::size_t>() + 1);
  EXPECT_THAT(read_file(results() / "compare.html"), HasSubstr("multipliers: minres"));
}

TEST_F(Program, TheReportPlotsTheResidualsOfAnIterationAlone) {
  ASSERT_EQ(run({"run", study(), "--set", "solver.method=\"cg\"", "--set", "discretization.refine=3"}), 0)
      << err_;
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("Residual of each iteration"));
  EXPECT_EQ(json::parse(read_file(results() / "summary.json"))["solver"]["tolerance"], 1e-10);
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  EXPECT_THAT(read_file(results() / "report.html"), testing::Not(HasSubstr("Residual of each iteration")));
}

TEST_F(Program, CompareRefusesLevelsOutOfRangeBeforeItSolves) {
  EXPECT_EQ(run({"compare", study(), "--levels", "0"}), 2);
  EXPECT_EQ(run({"compare", study(), "--levels", "3", "--set", "discretization.refine=9"}), 2);
  EXPECT_THAT(err_, HasSubstr("refine is 11"));
  EXPECT_EQ(run({"compare", study(), "--degrees", "2,11"}), 2);
  EXPECT_FALSE(fs::exists(results() / "compare.json"));
}

TEST(CompareLevels, SayThatTheCouplingsDisagree) {
  CouplingComparison comparison;
  EXPECT_TRUE(comparison.agree());
  comparison.multiplier_difference = 2e-8;
  EXPECT_FALSE(comparison.agree());
  EXPECT_THAT(disagreement_text(comparison), HasSubstr("2e-08 in multipliers (allowed 1e-08)"));
  EXPECT_THAT(levels_text({comparison}), HasSubstr("DISAGREE"));
}

// Levels with these internal energies.
std::vector<CouplingComparison> levels_of(const std::vector<double>& energies) {
  std::vector<CouplingComparison> levels;
  for (const double energy : energies) {
    CouplingComparison level;
    level.refine = static_cast<int>(levels.size());
    level.degree = {2, 2, 2};
    level.elimination.results.internal_energy = energy;
    level.elimination.size.dofs = level.lagrange.size.dofs = 1000 << (3 * levels.size());
    level.elimination.timings = level.lagrange.timings = {{"assembly", 1}, {"solve", 2}};
    levels.push_back(level);
  }
  return levels;
}

TEST(CompareLevels, ExtrapolateEnergiesThatConverge) {
  EXPECT_NEAR(extrapolated_energy(levels_of({9, 10 - 0.25, 10 - 0.0625})).value(), 10, 1e-12);
  EXPECT_FALSE(extrapolated_energy(levels_of({9, 9.75})));
  EXPECT_FALSE(extrapolated_energy(levels_of({9, 9.1, 9.3})));  // grow
  EXPECT_FALSE(extrapolated_energy(levels_of({9, 9.1, 9})));
  EXPECT_FALSE(extrapolated_energy(levels_of({9, 9, 9})));
  auto mixed = levels_of({9, 10 - 0.25, 10 - 0.0625});
  mixed[0].degree = {1, 1, 1};
  EXPECT_FALSE(extrapolated_energy(mixed));
}

TEST(CompareLevels, PlotTheOrderOfTheEnergy) {
  // Errors fall to a sixteenth when the unknowns become eight times as many: -4/3, as expected of degree 2.
  const auto plots = comparison_plots(levels_of({9, 10 - 1. / 16, 10 - 1. / 256}), 1e-10);
  ASSERT_FALSE(plots.empty());
  EXPECT_THAT(plots.back().svg, HasSubstr("<title>Error in energy over unknowns</title>"));
  for (const PagePlot& plot : plots)
    EXPECT_THAT(plot.svg, testing::Not(HasSubstr("<title>Nonzeros over unknowns"))) << "there are none";
  EXPECT_THAT(plots.back().svg, HasSubstr("degree 2: slope \u22121.33, expected \u22121.33"));
  const auto of_one = comparison_plots(levels_of({9}), 1e-10);
  ASSERT_EQ(of_one.size(), 1);
  EXPECT_THAT(of_one[0].svg, HasSubstr("<title>Time per phase</title>"));
}

std::vector<float> decoded(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (c == '=') break;
    group = group << 6U | static_cast<std::uint32_t>(letters.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255U);
  }
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  return values;
}

TEST_F(Program, ComparesPageDrawsTractionsOnInterfacesAlone) {
  ASSERT_EQ(run({"compare", study(), "--set", "discretization.degree=2", "--set", "model.patches=[2,2,1]"}),
            0)
      << err_;
  const std::string html = read_file(results() / "compare.html");
  const std::string begin = "id=\"isopatch-data\">";
  const auto from = html.find(begin) + begin.size();
  const json data = json::parse(html.substr(from, html.find("</script>", from) - from));
  EXPECT_EQ(data["kind"], "compare");
  EXPECT_EQ(data["summary"], compared(results()));
  EXPECT_THAT(data["plots"][0]["svg"].get<std::string>(), StartsWith("<svg"));
  const json& scene = data["scene"];
  const std::vector<float> points = decoded(scene["points"]);
  const std::vector<float> tractions = decoded(scene["traction"]);
  ASSERT_EQ(points.size(), tractions.size());
  std::size_t vertices = 0;
  for (const json& patch : scene["patches"])
    vertices += patch["sizes"][0].get<std::size_t>() * patch["sizes"][1].get<std::size_t>() *
                patch["sizes"][2].get<std::size_t>();
  ASSERT_EQ(points.size(), 3 * vertices);
  int on_cross_section = 0;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const bool on_cut = points[i] == 1;
    const bool on_middle = points[i + 1] == 0.5F;
    ASSERT_EQ(std::isnan(tractions[i]), !on_cut && !on_middle);
    if (!on_cut || on_middle) continue;
    ++on_cross_section;
    EXPECT_NEAR(tractions[i], 1e7, 10);
    EXPECT_NEAR(tractions[i + 1], 0, 10);
  }
  EXPECT_GT(on_cross_section, 0);
  EXPECT_EQ(scene["fields"].back()["key"], "traction");
  EXPECT_EQ(scene["fields"].back()["on"], "interfaces");
  const json& marker = scene["markers"].back();
  EXPECT_EQ(marker["kind"], "difference");
  EXPECT_EQ(marker["point"], data["summary"]["difference"]["max_von_mises_point"]);
  ASSERT_EQ(run({"compare", study(), "-q", "--set", "output.report=false"}), 0) << err_;
  EXPECT_FALSE(fs::exists(results() / "compare.html")) << "that of the earlier comparison is gone too";
}

}  // namespace
}  // namespace isopatch::app
