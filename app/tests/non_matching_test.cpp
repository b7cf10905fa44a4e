#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

/// A box as a patch of degree 1 in a .g2 file.
std::string box_text(double x0, double x1, double z0, double z1) {
  std::string text = "700 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n";
  for (const double z : {z0, z1})
    for (const double y : {0.0, 1.0})
      for (const double x : {x0, x1}) text += fmt::format("{} {} {}\n", x, y, z);
  return text;
}

/// A sector of 60 degrees of a pipe as a patch in a .g2 file. Its arcs run at another pace where the last
/// weight is another: the second is multiplied by `pace`, the third by its square.
std::string sector_text(double from, double to, double pace) {
  std::string text = "700 1 0 0\n3 1\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n2 2\n0 0 1 1\n";
  const double tangent = std::tan(std::numbers::pi / 6), half = std::sqrt(0.75);
  for (const double z : {0.0, 0.5})
    for (const Eigen::Vector3d& at : {Eigen::Vector3d(1, 0, 1), Eigen::Vector3d(1, tangent, half * pace),
                                      Eigen::Vector3d(0.5, half, pace * pace)})
      for (const double radius : {from, to})
        text += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", radius * at[0] * at[2],
                            radius * at[1] * at[2], z * at[2], at[2]);
  return text;
}

/// A box of 2 m x 1 m x 1 m with two smaller ones on its top, of which they leave a quarter free.
class NonMatching : public Program {
 protected:
  void SetUp() override {
    write_file(folder_ / "part.g2", box_text(0, 2, 0, 1) + box_text(0, 0.7, 1, 2) + box_text(0.7, 1.5, 1, 2));
    write_file(study(), R"([model]
file = "part.g2"
[[material]]
name = "steel"
[[support]]
faces = ["0:front"]
displacement = [0, 0, 0]
[[load]]
faces = ["1:back", "2:back"]
pressure = "1 MPa"
[coupling]
non_matching = "nitsche"
)");
  }
};

TEST_F(NonMatching, FacesAreNamedInPairsWithTheAreaThatTheyShare) {
  ASSERT_EQ(run({"info", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("3 patches, 1 interface, 2 that do not match, 14 boundary faces, one body"));
  EXPECT_THAT(out_, HasSubstr("faces that meet without matching\n  0:back"));
  ASSERT_EQ(run({"info", study(), "--json"}), 0) << err_;
  const json pairs = json::parse(out_)["non_matching"];
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0]["first"], "0:back");
  EXPECT_EQ(pairs[0]["second"], "1:front");
  EXPECT_EQ(pairs[1]["second"], "2:front");
  EXPECT_NEAR(pairs[0]["area"].get<double>(), 0.7, 1e-13);
  EXPECT_NEAR(pairs[1]["area"].get<double>(), 0.8, 1e-13);
}

// The quarter of the lower box's top that is free can be loaded, and no more.
TEST_F(NonMatching, PartsBesideWhatCoversAFaceAreFree) {
  const std::string load =
      "load=[{ faces = ['0:back'], pressure = '1 MPa', part = { box = "
      "{ min = [%, -1, 0], max = [3, 2, 3] } } }]";
  ASSERT_EQ(run({"run", study(), "--set", replaced(load, "%", "1.5")}), 0) << err_;
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_NEAR(summary["results"]["total_load"][2].get<double>(), -0.5e6, 1e-3);
  EXPECT_EQ(run({"run", study(), "--set", replaced(load, "%", "1.4")}), 2);
  EXPECT_THAT(err_, HasSubstr("2:front covers some of the part of face 0:back"));
}

TEST_F(NonMatching, LoadsOnCoveredFacesAreToldOfParts) {
  EXPECT_EQ(run({"run", study(), "--set", "load.0.faces=['0:back']"}), 2);
  EXPECT_THAT(err_, HasSubstr("face 0:back is covered in part by other patches"));
  EXPECT_THAT(err_, HasSubstr("part = { box = { min = [...], max = [...] } }"));
}

TEST_F(NonMatching, ModesSayThatNitschesMethodCouples) {
  const std::vector<std::string> modes = {"modes", study(),
                                          "--set", "material.0.density=7800",
                                          "--set", "load=[]",
                                          "--set", "discretization.degree=2",
                                          "--set", "coupling.non_matching=mortar"};
  ASSERT_EQ(run(modes), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("  not matching      0:back and 1:front, 0:back and 2:front\n"
                              "  coupled           by elimination and Nitsche's method\n"));
  EXPECT_EQ(err_.find("no load"), std::string::npos) << err_;
  const json found = json::parse(read_file(results() / "modes.json"));
  EXPECT_EQ(found["non_matching_coupling"], "nitsche");
  EXPECT_TRUE(found["warnings"].empty()) << found["warnings"];
}

TEST_F(NonMatching, BoundaryIsWhatNoOtherPatchCovers) {
  constexpr double surface = 2 + 6 + 0.5 + 1.5 + 5;  // below, around, and on top of both layers
  const auto area = [](const json& model) {
    double sum = 0;
    for (const json& face : model["boundary_faces"]) {
      sum += face["area"].get<double>();
      if (face["face"] == "0:back") {
        EXPECT_NEAR(face["area"].get<double>(), 0.5, 1e-13);
      }
    }
    EXPECT_NEAR(model["boundary_area"].get<double>(), sum, 1e-12);
    return sum;
  };
  ASSERT_EQ(run({"info", study(), "--json"}), 0) << err_;
  EXPECT_NEAR(area(json::parse(out_)), surface, 1e-12);
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("not matching      0:back and 1:front, 0:back and 2:front\n"));
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_NEAR(summary["model"]["boundary_area"].get<double>(), surface, 1e-12);
  EXPECT_EQ(summary["model"]["non_matching"].size(), 2u);
  ASSERT_EQ(run({"info", (results() / "results.h5").string(), "--json"}), 0) << err_;
  EXPECT_NEAR(area(json::parse(out_)), surface, 1e-12);
}

TEST_F(NonMatching, MortarSaysWhichFacesHaveTheMultipliersAndAgreesWithNitsche) {
  ASSERT_EQ(run({"run", study(), "--set", "discretization.refine=2"}), 0) << err_;
  const json nitsche = json::parse(read_file(results() / "summary.json"));
  EXPECT_EQ(nitsche["non_matching_coupling"], "nitsche");
  EXPECT_EQ(nitsche["results"]["mortar"].size(), 0u);
  ASSERT_EQ(
      run({"run", study(), "--set", "discretization.refine=2", "--set", "coupling.non_matching=mortar"}), 0)
      << err_;
  EXPECT_THAT(
      out_, HasSubstr("coupled by elimination and mortar multipliers\n  multipliers on    1:front (the only "
                      "side that is covered all over), 2:front ("));
  const json mortar = json::parse(read_file(results() / "summary.json"));
  ASSERT_EQ(mortar["results"]["mortar"].size(), 2u);
  EXPECT_EQ(mortar["results"]["mortar"][0]["covered_by"], json({"0:back"}));
  // All of the pressure goes through both.
  EXPECT_NEAR(mortar["results"]["mortar"][0]["force"][2].get<double>() +
                  mortar["results"]["mortar"][1]["force"][2].get<double>(),
              1.5e6, 1e-2);
  const double energies[] = {nitsche["results"]["internal_energy"].get<double>(),
                             mortar["results"]["internal_energy"].get<double>()};
  EXPECT_NE(energies[0], energies[1]);
  EXPECT_NEAR(energies[0] / energies[1], 1, 0.01);
}

TEST_F(NonMatching, AMortarSideWithoutMortarMultipliersIsRefused) {
  for (const char* way : {"nitsche", "refuse"}) {
    EXPECT_EQ(run({"run", study(), "--set", std::string("coupling.non_matching=") + way, "--set",
                   "coupling.mortar_side=other"}),
              2);
    EXPECT_THAT(err_,
                HasSubstr("mortar_side says which side has the mortar multipliers, which are there with "
                          "coupling.non_matching = \"mortar\" alone"));
  }
}

// A corner of two patches is two nodes.
TEST_F(NonMatching, PointsAreHeldInEveryPatchThatHasThem) {
  const std::string pin = "{ name = 'pin', points = [[0, 0, 1]], displacement = [0, 0, 0] }";
  const std::string ground = "{ faces = ['0:front'], displacement = [0, 0, 0] }";
  for (const char* way : {"nitsche", "mortar"}) {
    ASSERT_EQ(run({"run", study(), "--set", "support=[" + ground + ", " + pin + "]", "--set",
                   std::string("coupling.non_matching=") + way}),
              0)
        << err_;
    const std::string results_file = (results() / "results.h5").string();
    for (const auto& [patch, parameter] : {std::pair("0", "0,0,1"), std::pair("1", "0,0,0")}) {
      ASSERT_EQ(run({"probe", results_file, "--patch", patch, "--parameter", parameter, "--json"}), 0)
          << err_;
      for (const json& component : json::parse(out_)["displacement"])
        EXPECT_LT(std::abs(component.get<double>()), 1e-20) << way << ", patch " << patch;
    }
  }
}

TEST_F(NonMatching, BothWaysAreComparedWithinTheErrorOfTheDiscretization) {
  ASSERT_EQ(run({"compare", study(), "--set", "discretization.refine=2"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("faces that do not match by nitsche and by mortar: energy"));
  EXPECT_THAT(out_, HasSubstr("(within twice the estimated error"));
  const json compared = json::parse(read_file(results() / "compare.json"))["non_matching"];
  EXPECT_TRUE(compared["agree"]);
  EXPECT_GT(compared["energy_difference"].get<double>(), 1e-6);
  EXPECT_LT(compared["energy_difference"].get<double>(), compared["allowed_difference"].get<double>());
  // No side is covered all over.
  write_file(folder_ / "part.g2", box_text(0, 2, 0, 1) + box_text(0.5, 2.5, 1, 2));
  ASSERT_EQ(run({"compare", study(), "--set", "load.0.faces=['1:back']"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("not compared with mortar: the mortar method needs a side"));
}

TEST_F(NonMatching, MortarNeedsASideThatIsCoveredAllOver) {
  write_file(folder_ / "part.g2", box_text(0, 2, 0, 1) + box_text(0.5, 2.5, 1, 2));
  EXPECT_NE(
      run({"run", study(), "--set", "coupling.non_matching=mortar", "--set", "load.0.faces=['1:back']"}), 0);
  EXPECT_THAT(err_, HasSubstr("parts stay free; set non_matching = \"nitsche\""));
}

// Two layers of a pipe whose common arcs are the same at another pace, beside the same at one pace.
TEST_F(NonMatching, ArcsOfOtherRationalParametersAreCoupled) {
  const auto energy = [&](double pace, const std::string& way) {
    write_file(folder_ / "part.g2", sector_text(1, 1.4, 1) + sector_text(1.4, 2, pace));
    EXPECT_EQ(run({"run", study(), "--set", "coupling.non_matching='" + way + "'", "--set",
                   "discretization={ degree = 3, refine = 2 }", "--set",
                   "support=[{ faces = ['0:south', '1:south', '0:north', '1:north'], symmetry = true }, "
                   "{ faces = ['0:front', '1:front'], symmetry = true }]",
                   "--set", "load=[{ faces = ['0:west'], pressure = '10 MPa' }]"}),
              0)
        << err_;
    const json summary = json::parse(read_file(results() / "summary.json"));
    EXPECT_EQ(summary["model"]["non_matching_interfaces"], pace == 1 ? 0 : 1);
    return summary["results"]["external_work"].get<double>();
  };
  const double matching = energy(1, "nitsche");
  EXPECT_NEAR(energy(2.5, "nitsche") / matching, 1, 1e-5);
  EXPECT_NEAR(energy(2.5, "mortar") / matching, 1, 1e-5);
}

}  // namespace
}  // namespace isopatch::app
