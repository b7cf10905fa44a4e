#include "app/results/write_fields.hpp"
#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

using testing::Not;

const std::string block = R"([model]
generate = "box"
[[material]]
name = "steel"
[[support]]
name = "wall"
faces = ["x_min"]
displacement = [0, 0, 0]
[[load]]
name = "pull"
faces = ["x_max"]
traction = ["1 MPa", 0, 0]
)";

class Plausibility : public Program {
 protected:
  json summary_of(const std::string& text) {
    EXPECT_EQ(run_text(text), 0) << err_;
    return json::parse(read_file(results() / "summary.json"));
  }
};

TEST_F(Plausibility, AReasonableStudyHasNoWarning) {
  const json summary = summary_of(block);
  EXPECT_THAT(err_, Not(HasSubstr("warning")));
  EXPECT_EQ(summary["supports"][0]["name"], "wall");
  EXPECT_EQ(summary["loads"][0]["name"], "pull");
  EXPECT_EQ(summary["results"]["reactions"][0]["support"], "wall");
}

TEST_F(Plausibility, ModuliThatNoSolidHasAreNamedWithTheUnitThatWasMeant) {
  summary_of(replaced(block, "name = \"steel\"", "young = 210000\npoisson = 0.3"));
  EXPECT_THAT(err_, HasSubstr("Young's modulus of material 1 is 210 kPa, less than that of any solid"));
  EXPECT_THAT(err_, HasSubstr("\"210 GPa\""));
  EXPECT_THAT(err_, HasSubstr("is more than the part's size"));
  EXPECT_THAT(err_, HasSubstr("linear elasticity is for small ones"));
  summary_of(replaced(block, "name = \"steel\"", "young = \"210000 GPa\"\npoisson = 0.3"));
  EXPECT_THAT(err_, HasSubstr("more than that of any solid"));
}

TEST_F(Plausibility, DensitiesYieldsAndExpansionsThatNoSolidHasAreNamedToo) {
  const std::string steel = "young = 210e9\npoisson = 0.3\n";
  summary_of(replaced(block, "name = \"steel\"", steel + "density = 7.85\nyield = 355\nexpansion = 12"));
  EXPECT_THAT(err_, HasSubstr("the density of material 1 is 7.85 kg/m^3, less than that of any solid"));
  EXPECT_THAT(err_, HasSubstr("the yield stress of material 1 is 355 Pa, less than"));
  EXPECT_THAT(err_, HasSubstr("the thermal expansion of material 1 is 12 1/K, more than"));
  summary_of(replaced(block, "name = \"steel\"", steel + "density = 7850\nyield = 355e6\nexpansion = 12e-6"));
  EXPECT_THAT(err_, Not(HasSubstr("warning")));
  // Invar of low temperatures shrinks.
  summary_of(replaced(block, "name = \"steel\"", steel + "expansion = -1e-6"));
  EXPECT_THAT(err_, Not(HasSubstr("warning")));
}

TEST_F(Plausibility, ALoadThatSupportsTakeWholeIsNamed) {
  summary_of(block + "[[load]]\nname = \"lost\"\nfaces = [\"x_min\"]\npressure = 1e6\n");
  EXPECT_THAT(err_, HasSubstr("load 2 (lost) moves nothing"));
  EXPECT_THAT(err_, Not(HasSubstr("load 1")));
}

// Beside the corners of a wall that stays cold elements of degree 1 are too few for either; warmth alone has
// no compliance, whose displacements would be too small.
TEST_F(Plausibility, LargeElementsMakeDisplacementsUnderLoadsTooSmallAndNotThoseOfWarmth) {
  const std::string coarse = "[discretization]\ndegree = 1\nrefine = 0\n";
  const std::string bent = replaced(block, "traction = [\"1 MPa\", 0, 0]", "traction = [0, \"1 MPa\", 0]");
  summary_of(bent + coarse);
  EXPECT_THAT(err_,
              HasSubstr("of the elements, and displacements under loads are too small by about as much"));
  summary_of(replaced(block, "faces = [\"x_max\"]\ntraction = [\"1 MPa\", 0, 0]",
                      "temperature = { gradient = [0, \"200 K/m\", 0] }") +
             coarse);
  EXPECT_THAT(err_, HasSubstr("% of the energy is in the highest polynomials of the elements. "));
  EXPECT_THAT(err_, Not(HasSubstr("under loads")));
}

TEST_F(Plausibility, ACouplingWithNothingToCoupleIsSaid) {
  const std::string coupled = "[coupling]\nnon_matching = \"nitsche\"\n";
  summary_of(block + coupled);
  EXPECT_THAT(out_,
              HasSubstr("nothing: there is one patch, and coupling.non_matching has nothing to couple"));
  summary_of(replaced(block, "\"box\"", "\"box\"\npatches = [2, 1, 1]") + coupled);
  EXPECT_THAT(out_, HasSubstr("not matching      nothing: all patches meet side to side"));
  summary_of(block);
  EXPECT_THAT(out_, Not(HasSubstr("not matching")));
}

TEST_F(Plausibility, StressThatHexahedraDoNotFollowIsSaidWithItsPlace) {
  EXPECT_FALSE(fit_warning({}, 1)) << "of given pieces nothing is known";
  EXPECT_FALSE(fit_warning(iga::FitReport{.off = 0.0099, .patch = 3}, 1));
  const auto warning = fit_warning(iga::FitReport{.off = 0.27, .patch = 3, .place = {0.1, 0.02, 0}}, 0.2);
  ASSERT_TRUE(warning);
  EXPECT_THAT(warning->text, HasSubstr("is off by up to 27 % of the largest, in patch 3 at (100, 20, 0) mm"));
}

// Of a series of studies one may have no load.
TEST_F(Plausibility, ALoadOfNothingIsTakenByNoSupport) {
  summary_of(block + "[[load]]\nfaces = [\"y_max\"]\npressure = 0\n");
  EXPECT_THAT(err_, Not(HasSubstr("moves nothing")));
}

TEST_F(Plausibility, NamesThatAreSharedAreSaid) {
  summary_of(block + "[[support]]\nname = \"wall\"\nfaces = [\"y_min\"]\nsymmetry = true\n" +
             "[[probe]]\nname = \"p\"\npoint = [1, 1, 1]\n[[probe]]\nname = \"p\"\npoint = [1, 0, 1]\n");
  EXPECT_THAT(err_, HasSubstr("2 supports have the name \"wall\""));
  EXPECT_THAT(err_, HasSubstr("2 probes have the name \"p\""));
}

TEST_F(Plausibility, DegreeTwoIsTheDefaultAndDegreeOneInBendingIsSaid) {
  const std::string bent = replaced(replaced(block, "\"box\"", "\"box\"\nsize = [5, 1, 1]"),
                                    "[\"1 MPa\", 0, 0]", "[0, 0, \"1 MPa\"]");
  EXPECT_EQ(summary_of(bent)["discretization"]["degree"], json::array({2, 2, 2}));
  const json poor = summary_of(bent + "[discretization]\ndegree = 1\nrefine = 1\n");
  EXPECT_EQ(poor["discretization"]["degree"], json::array({1, 1, 1}));
  EXPECT_GT(poor["results"]["unresolved_energy_share"], 0.2);
  EXPECT_THAT(err_, HasSubstr("elements of degree 1"));
  EXPECT_THAT(err_, HasSubstr("discretization.degree = 2 mends it"));
}

// Lame: radii 3 and 9, plane strain, E = 1 GPa, pressure 1 MPa.
constexpr double exact_at_bore(double nu) {
  return (1 + nu) / 1e9 * (1e6 * 9 / 72) * ((1 - 2 * nu) * 3 + 81.0 / 3);
}
const std::string thick = R"([model]
generate = "cylinder"
inner_radius = 3
outer_radius = 9
height = 1
[[material]]
young = 1e9
poisson = 0.499
[[support]]
faces = ["start", "end", "bottom", "top"]
symmetry = true
[[load]]
faces = ["inner"]
pressure = 1e6
[[probe]]
point = [3, 0, 0.5]
[discretization]
)";

// What is held about an axis is held at points, between which a coarse part gives way: 18 % too much where
// eight elements go around.
TEST_F(Plausibility, NothingIsSaidOfDisplacementsWhereSupportsHoldAtPoints) {
  const std::string held =
      replaced(replaced(thick, "[[probe]]",
                        "[[support]]\nfaces = [\"outer\"]\ncylindrical = { radial = \"fixed\" }\n[[probe]]"),
               "0.499", "0.3");
  summary_of(held + "degree = 1\nrefine = 0\n");
  EXPECT_THAT(err_, HasSubstr("% of the energy is in the highest polynomials of the elements. "));
  EXPECT_THAT(err_, Not(HasSubstr("too small")));
}

TEST_F(Plausibility, LockingIsSaidAndItsAdviceMendsIt) {
  const auto at_bore = [](const json& summary) {
    return summary["probes"][0]["displacement"][0].get<double>() / exact_at_bore(0.499);
  };
  EXPECT_LT(at_bore(summary_of(thick + "degree = 2\nrefine = 2\n")), 0.92);
  EXPECT_THAT(err_, HasSubstr("degree 2 cannot keep the volume of nearly incompressible material"));
  EXPECT_THAT(err_, HasSubstr("discretization.degree = 4 mends it"));
  EXPECT_NEAR(at_bore(summary_of(thick + "degree = 4\nrefine = 2\n")), 1, 1e-2);
  EXPECT_THAT(err_, Not(HasSubstr("incompressible")));
}

// At the bore the stress along the radius is -1 MPa, and that around it 1.25 MPa.
TEST_F(Plausibility, StressesThatOscillateWithTheVolumeAreSaidTo) {
  const json results = summary_of(replaced(thick, "0.499", "0.4999") + "degree = 2\nrefine = 2\n")["results"];
  EXPECT_GT(results["max_principal"].get<double>(), 3e6);
  EXPECT_THAT(err_, HasSubstr("Poisson's ratio 0.4999: errors of the volume's change count 2500 times"));
  summary_of(replaced(thick, "0.499", "0.3") + "degree = 2\nrefine = 2\n");
  EXPECT_THAT(err_, Not(HasSubstr("the volume's change")));
}

// A body that nothing holds grows without stress; what is computed, some 1e-4 Pa, is round-off of 210 GPa.
TEST_F(Plausibility, StressOfRoundOffIsShownAsNone) {
  const json results = summary_of(replaced(
      replaced(replaced(block, "name = \"steel\"", "young = 210e9\npoisson = 0.3\nexpansion = 12e-6"),
               "faces = [\"x_min\"]\ndisplacement = [0, 0, 0]", "free_body = true"),
      "faces = [\"x_max\"]\ntraction = [\"1 MPa\", 0, 0]", "temperature = { change = 100 }"))["results"];
  EXPECT_THAT(out_, HasSubstr("max von Mises     0 Pa at"));
  EXPECT_THAT(out_, HasSubstr("max Tresca        0 Pa at"));
  EXPECT_THAT(out_, Not(HasSubstr("+-")));
  const double round_off = results["stress_round_off"], most = results["max_von_mises"];
  EXPECT_LT(most, round_off);
  EXPECT_LT(round_off, 1);
}

TEST_F(Plausibility, TheLargestStressIsOneFigureWhereverItIsSaid) {
  const json summary = summary_of(replaced(thick, "0.499", "0.3") + "degree = 3\nrefine = 1\n");
  const double largest = summary["results"]["max_von_mises"];
  // The bore is on the boundary, where no Gauss point lies.
  EXPECT_GE(largest, summary["probes"][0]["von_mises"].get<double>() * (1 - 1e-9));
  EXPECT_THAT(out_, HasSubstr("(of Gauss points and faces)"));
  const std::string file = (results() / "results.h5").string();
  ASSERT_EQ(run({"info", file}), 0) << err_;
  const auto at = out_.find("max von Mises ") + 14;
  const std::string figure = out_.substr(at, out_.find(',', at) - at);
  ASSERT_EQ(run({"run", study()}), 0);
  EXPECT_THAT(out_, HasSubstr("max von Mises     " + figure.substr(0, figure.find(' ')) + " +- "));
  if (run({"render", file, (folder_ / "picture.png").string(), "--field", "von_mises"}) == 0) {
    EXPECT_THAT(out_, HasSubstr("max " + figure));
  }
}

}  // namespace
}  // namespace isopatch::app
