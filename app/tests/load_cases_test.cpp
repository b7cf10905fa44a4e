#include "app/study/load_cases.hpp"

#include "app/study/parse_study.hpp"
#include "app/tests/program_fixture.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::app {
namespace {

// A bar on guides, pulled, pushed sideways, and pressed shorter; E = 1 GPa, nu = 0.25, 2 m long, 1 m^2.
const std::string three_cases = guided_bar + R"([[support]]
name = "press"
case = "pressed"
faces = ["x_max"]
displacement = [-0.002, "free", "free"]
[[load]]
name = "side"
case = ["squeezed", "both"]
faces = ["y_max"]
traction = [0, -1e6, 0]
[[load]]
name = "top"
case = "both"
faces = ["z_max"]
pressure = 2e6
[[combination]]
name = "worst"
factors = { pressed = 1.5, both = -2 }
[[probe]]
name = "end"
point = [2, 1, 1]
)";

Study parsed(const std::string& text) {
  return parse_study(text, "study.toml", {});
}

TEST(LoadCases, CollectWhatNamesThem) {
  const iga::LoadCases cases = load_cases(parsed(three_cases));
  ASSERT_EQ(cases.cases.size(), 3u);
  EXPECT_EQ(cases.cases[0].name, "squeezed");
  EXPECT_THAT(cases.cases[0].loads, testing::ElementsAre("load 1 (side)"));
  EXPECT_THAT(cases.cases[0].moving_supports, testing::ElementsAre("support 1 (guides)"));
  EXPECT_EQ(cases.cases[1].name, "both");
  EXPECT_THAT(cases.cases[1].loads, testing::ElementsAre("load 1 (side)", "load 2 (top)"));
  EXPECT_EQ(cases.cases[2].name, "pressed");
  EXPECT_THAT(cases.cases[2].loads, testing::IsEmpty());
  EXPECT_THAT(cases.cases[2].moving_supports,
              testing::ElementsAre("support 1 (guides)", "support 2 (press)"));
  ASSERT_EQ(cases.combinations.size(), 1u);
  EXPECT_THAT(cases.combinations[0].factors, testing::ElementsAre(0, -2, 1.5));
  EXPECT_TRUE(load_cases(parsed(bar)).cases.empty());
}

TEST(LoadCases, WhatCannotBeMeantIsRefusedWithItsPlace) {
  const auto expect = [](const std::string& from, const std::string& to, const std::string& word) {
    EXPECT_ERROR(load_cases(parsed(replaced(three_cases, from, to))), ErrorCode::invalid_argument, word);
  };
  expect("case = \"both\"\n", "", "load 2 (top) is in no load case");
  expect("pressed = 1.5", "presed = 1.5", "did you mean 'pressed'?");
  expect("name = \"worst\"", "name = \"both\"", "the name \"both\" is that of a case");
  expect("case = \"pressed\"\n", "", "prescribes a displacement in every load case");
  expect("[\"squeezed\", \"both\"]", "[\"both\", \"both\"]", "\"both\" is there twice");
  expect("[\"squeezed\", \"both\"]", "[]", "names no case");
  expect("case = \"both\"", "case = \"../both\"", "cannot be the name of a load case");
  expect("{ pressed = 1.5, both = -2 }", "{ }", "factors names no case");
  expect("{ pressed = 1.5, both = -2 }", "{ pressed = 0 }", "\"worst\" has no factor but 0");
  expect("name = \"guides\"", "name = \"guides\"\ncase = \"both\"",
         "prescribes no displacement, so it has no case");
  EXPECT_ERROR(load_cases(parsed(bar + "[[combination]]\nfactors = { a = 1 }\n")),
               ErrorCode::invalid_argument, "study.toml:19:1: [[combination]] needs load cases");
}

class CasesOfProgram : public Program {
 protected:
  // The results of one case in summary.json.
  json of_case(const std::string& name) const {
    const json summary = json::parse(read_file(results() / "summary.json"));
    for (const json& one : summary["cases"])
      if (one["name"] == name) return one;
    return {};
  }
};

// Uniaxial and biaxial stress by hand: the end moves by eps_x * 2 m.
TEST_F(CasesOfProgram, HaveTheirOwnResults) {
  for (const std::string coupling : {"elimination", "lagrange"}) {
    ASSERT_EQ(run_text(three_cases, {"--set", "coupling.method=" + coupling}), 0) << err_;
    constexpr double round_off = 1e-12;
    const auto end = [&](const char* name) {
      return of_case(name)["probes"][0]["displacement"][0].get<double>();
    };
    // Held at x_max by the press, which does not move in other cases.
    EXPECT_NEAR(end("squeezed"), 0, round_off);
    EXPECT_NEAR(end("pressed"), -0.002, round_off);
    EXPECT_NEAR(end("worst"), -0.003, round_off);
    // sigma_x = nu (sigma_y + sigma_z) where the length is held.
    const auto stress = [&](const char* name) {
      return of_case(name)["probes"][0]["stress"][0].get<double>();
    };
    EXPECT_NEAR(stress("squeezed"), -0.25e6, 1);
    EXPECT_NEAR(stress("both"), -0.75e6, 1);
    EXPECT_NEAR(stress("pressed"), -1e6, 1);
    EXPECT_NEAR(stress("worst"), 1.5 * -1e6 + 2 * 0.75e6, 1);
    // Every case and combination has an estimate; constant stresses are in the space.
    for (const char* name : {"squeezed", "both", "pressed", "worst"})
      EXPECT_LT(of_case(name)["results"]["discretization_error"]["energy_norm"].get<double>(), 1e-6) << name;
    EXPECT_EQ(of_case("worst")["kind"], "combination");
    EXPECT_EQ(of_case("worst")["factors"]["both"], -2);
    EXPECT_THAT(out_, HasSubstr("case squeezed: side\n"));
    EXPECT_THAT(out_, HasSubstr("combination worst: -2 both + 1.5 pressed\n"));
  }
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_EQ(summary["schema_version"], 2);
  EXPECT_EQ(summary["results"], of_case("squeezed")["results"]);
}

TEST_F(CasesOfProgram, AreAllInTheFiles) {
  ASSERT_EQ(run_text(three_cases), 0) << err_;
  EXPECT_FALSE(fs::exists(results() / "results.vtm"));
  for (const char* name : {"squeezed", "both", "pressed", "worst"}) {
    EXPECT_TRUE(fs::exists(results() / "cases" / name / "results.vtm")) << name;
    EXPECT_TRUE(fs::exists(results() / "cases" / name / "fields" / "patch_000.vtu")) << name;
    EXPECT_THAT(read_file(results() / "cases" / name / "report.html"), HasSubstr("../worst/report.html"));
  }
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("cases/worst/report.html"));
  EXPECT_FALSE(fs::exists(results() / "unfinished"));
  const std::string stored = (results() / "results.h5").string();
  ASSERT_EQ(run({"probe", stored, "--point", "2,1,1", "--case", "worst", "--json"}), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["displacement"][0].get<double>(), -0.003, 1e-12);
  EXPECT_EQ(json::parse(out_)["case"], "worst");
  ASSERT_EQ(run({"probe", stored, "--point", "2,1,1", "--case", "worst"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("case          worst, of squeezed, both, pressed, worst"));
  ASSERT_EQ(run({"probe", stored, "--line", "2,0,1", "2,1,1", "--count", "2", "--case", "worst"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr(",-0.003"));
  ASSERT_EQ(run({"probe", stored, "--point", "2,1,1", "--json"}), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["displacement"][0].get<double>(), 0, 1e-12);
  EXPECT_NE(run({"probe", stored, "--point", "2,1,1", "--case", "wort"}), 0);
  EXPECT_THAT(
      err_, HasSubstr("no load case 'wort' (did you mean 'worst'?); it has squeezed, both, pressed, worst"));
  ASSERT_EQ(run({"report", stored, "--case", "worst"}), 0) << err_;
  EXPECT_THAT(read_file(results() / "report.html"), HasSubstr("\"case\": \"worst\""));
  ASSERT_EQ(run({"fields", stored, "--case", "worst", "-o", (folder_ / "fields").string()}), 0) << err_;
  // Without cases the folders of an earlier run go.
  ASSERT_EQ(run_text(bar), 0) << err_;
  EXPECT_FALSE(fs::exists(results() / "cases"));
  EXPECT_TRUE(fs::exists(results() / "results.vtm"));
  EXPECT_EQ(json::parse(read_file(results() / "summary.json"))["cases"], json::array());
}

}  // namespace
}  // namespace isopatch::app
