#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

// A bar of 2 x 1 x 1 m in tension of 10 MPa, of density 1000 and yield 25 MPa, cut in its middle.
const std::string measured =
    replaced(bar, "poisson = 0.25\n", "poisson = 0.25\ndensity = 1000\nyield = \"25 MPa\"\n") + R"([[section]]
name = "middle"
point = [1, 0, 0]
normal = "x"
[output]
moments_about = [0, 0.5, 0.5]
)";

class Measured : public Program {
 protected:
  json summary() const { return json::parse(read_file(results() / "summary.json")); }
};

TEST_F(Measured, StressesOfABarInTension) {
  ASSERT_EQ(run_text(measured), 0) << err_;
  const json found = summary()["results"];
  constexpr double round_off = 1e-3;  // Pa, of 1e7
  EXPECT_NEAR(found["max_principal"], 1e7, round_off);
  EXPECT_NEAR(found["min_principal"], 0, round_off);
  EXPECT_NEAR(found["max_tresca"], 1e7, round_off);
  EXPECT_NEAR(found["min_safety_factor"], 2.5, 1e-9);
  EXPECT_FALSE(found["max_tresca_at"].is_null());
  EXPECT_THAT(out_, HasSubstr("safety factor     2.5 against yield"));
  EXPECT_THAT(out_, HasSubstr("max Tresca        10 MPa"));
  const json end = summary()["probes"][0];
  EXPECT_NEAR(end["principal"][0], 1e7, round_off);
  EXPECT_NEAR(end["tresca"], 1e7, round_off);
}

TEST_F(Measured, MassOfABar) {
  ASSERT_EQ(run_text(measured), 0) << err_;
  const json mass = summary()["mass"];
  EXPECT_NEAR(mass["mass"], 2000, 1e-9);
  const double centre[] = {1, 0.5, 0.5};
  // m / 12 (b^2 + c^2).
  const double inertia[] = {2000. / 12 * 2, 2000. / 12 * 5, 2000. / 12 * 5, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(mass["centre"][i], centre[i], 1e-12) << i;
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(mass["inertia"][i], inertia[i], 1e-9) << i;
  ASSERT_EQ(run_text(replaced(measured, "density = 1000\n", "")), 0) << err_;
  EXPECT_TRUE(summary()["mass"].is_null());
}

TEST_F(Measured, ForcesOfASectionAndMomentsOfReactions) {
  for (const std::string coupling : {"elimination", "lagrange"}) {
    ASSERT_EQ(run_text(measured, {"--set", "coupling.method=" + coupling}), 0) << err_;
    const json section = summary()["sections"][0];
    EXPECT_EQ(section["name"], "middle");
    EXPECT_NEAR(section["area"], 1, 1e-12);
    EXPECT_NEAR(section["force"][0], 1e7, 1e-3);
    // About a corner of the section: arm (0, 1/2, 1/2).
    EXPECT_NEAR(section["moment"][1], 0.5e7, 1e-3);
    EXPECT_NEAR(section["moment"][2], -0.5e7, 1e-3);
    EXPECT_THAT(out_, HasSubstr("middle            (10, 0, 0) MN and (0, 5, -5) MN m"));
    // The reaction acts in the middle of x_min, so has no moment there, and (0, -F/2, F/2) about the origin.
    const json reaction = summary()["results"]["reactions"][0];
    EXPECT_NEAR(reaction["moment"][1], -0.5e7, 1e-3);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(reaction["moment_about_point"][i], 0, 1e-3) << i;
  }
  EXPECT_NE(run_text(replaced(measured, "point = [1, 0, 0]", "point = [3, 0, 0]")), 0);
  EXPECT_THAT(err_, HasSubstr("middle: the plane does not cut the part"));
}

TEST_F(Measured, ProbeSaysPrincipalDirections) {
  ASSERT_EQ(run_text(measured), 0) << err_;
  const std::string stored = (results() / "results.h5").string();
  ASSERT_EQ(run({"probe", stored, "--point", "1,0.5,0.5", "--json"}), 0) << err_;
  const json found = json::parse(out_);
  EXPECT_NEAR(found["principal"][0], 1e7, 1e-3);
  EXPECT_NEAR(std::abs(found["principal_directions"][0][0].get<double>()), 1, 1e-9);
  EXPECT_NEAR(found["safety_factor"], 2.5, 1e-9);
  ASSERT_EQ(run({"probe", stored, "--point", "1,0.5,0.5"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("principal     1e+07 Pa along"));
  EXPECT_THAT(out_, HasSubstr("safety factor 2.5 against yield"));
}

TEST_F(Measured, GradesHaveTheirYieldStress) {
  const std::string graded =
      replaced(replaced(measured, "young = 1e9\npoisson = 0.25\ndensity = 1000\n", "name = \"S355\"\n"),
               "yield = \"25 MPa\"\n", "");
  ASSERT_EQ(run_text(graded), 0) << err_;
  EXPECT_EQ(summary()["materials"][0]["yield"], 355e6);
  EXPECT_NEAR(summary()["results"]["min_safety_factor"], 35.5, 1e-8);
  ASSERT_EQ(run_text(replaced(graded, "\"S355\"\n", "\"S355\"\nyield = 5e8\n")), 0) << err_;
  EXPECT_EQ(summary()["materials"][0]["yield"], 5e8);
}

}  // namespace
}  // namespace isopatch::app
