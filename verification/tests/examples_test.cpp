// Every example as its reader runs it: the program's own summary against the figures of its README.

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "app/commands/program.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/temporary_folder.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// Runs examples in a folder that goes with the test.
class Examples : public testing::Test {
 protected:
  /// The summary of an example, which must run; {} if it does not.
  json summary_of(const std::string& name, const std::vector<std::string>& more = {}) const {
    const fs::path study = fs::path(ISOPATCH_SOURCE_DIR) / "examples" / name / "study.toml";
    std::vector<std::string> arguments = {"run", study.string(), "--output", folder_.string(), "--quiet"};
    for (const char* setting : {"output.fields=false", "output.hdf5=false"})
      arguments.insert(arguments.end(), {"--set", setting});
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::ostringstream out;
    std::ostringstream err;
    const int code = app::run_program(arguments, {out, err, false, false, true});
    EXPECT_EQ(code, 0) << err.str();
    return code == 0 ? json::parse(read_file(folder_ / "summary.json")) : json::object();
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

double at(const json& values, const char* pointer) {
  return values.at(json::json_pointer(pointer)).get<double>();
}

constexpr double same = 1e-6;         // relative; figures are given with seven digits or more
constexpr double equilibrium = 1e-9;  // relative; the solver's residual is below 1e-10

void expect_figures(const json& summary, int dofs_free, double energy, double max_displacement) {
  ASSERT_FALSE(summary.empty());
  EXPECT_EQ(at(summary, "/discretization/dofs_free"), dofs_free);
  EXPECT_NEAR(at(summary, "/results/internal_energy") / energy, 1, same);
  EXPECT_NEAR(at(summary, "/results/external_work") / energy, 1, same);
  EXPECT_NEAR(at(summary, "/results/max_displacement") / max_displacement, 1, same);
}

void expect_vector(const json& found, const std::array<double, 3>& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i].get<double>(), expected[i], tolerance) << i;
}

TEST_F(Examples, LinkHasItsFiguresWithBothCouplings) {
  for (const auto& [coupling, dofs_free] : {std::pair("elimination", 2985), std::pair("lagrange", 4665)}) {
    const json summary = summary_of("link", {"--set", std::string("coupling.method=") + coupling});
    ASSERT_FALSE(summary.empty());
    EXPECT_EQ(summary.at("coupling"), coupling);
    expect_figures(summary, dofs_free, 0.578526884, 0.577168047e-3);
    expect_vector(summary["results"]["reactions"][0]["force"], {-1e4, 2e3, 0}, equilibrium * 1e4);
    EXPECT_NEAR(at(summary, "/results/max_von_mises") / 375.796592e6, 1, same);
    EXPECT_EQ(summary["supports"][0]["faces"].size(), 4u);
    // The whole bores: 2 pi r times the thickness.
    EXPECT_NEAR(at(summary, "/supports/0/area"), 2 * std::numbers::pi * 0.010 * 0.012, 1e-13);
    EXPECT_NEAR(at(summary, "/loads/0/area"), 2 * std::numbers::pi * 0.007 * 0.012, 1e-13);
  }
}

TEST_F(Examples, PatchTestFollowsTheLinearDisplacement) {
  const json summary = summary_of("patch_test");
  // The strain is the same everywhere: E = 1 GPa, nu = 0.3 give this energy in a cube of 1 m^3.
  constexpr double lambda = 0.3e9 / (1.3 * 0.4);
  constexpr double mu = 1e9 / 2.6;
  constexpr double xx = 1e-3, yy = -5e-4, zz = 8e-4, xy = 3.5e-4, yz = 3.5e-4, zx = -1.5e-4;
  constexpr double trace = xx + yy + zz;
  constexpr double squares = xx * xx + yy * yy + zz * zz + 2 * (xy * xy + yz * yz + zx * zx);
  expect_figures(summary, 81, 0.5 * lambda * trace * trace + mu * squares, 3.5341194094e-3);
  expect_vector(summary["probes"][0]["displacement"], {1.5e-3, -2.095e-3, 1.27e-3}, 1e-15);
  EXPECT_EQ(summary["supports"][0]["faces"].size(), 24u);
  EXPECT_NEAR(at(summary, "/supports/0/area"), 6, 1e-12);
}

TEST_F(Examples, ThickCylinderHasLamesSolution) {
  const json summary = summary_of("thick_cylinder");
  constexpr double inner = 1.3e-3 * (10.0 / 3) * (0.4 + 4);
  constexpr double outer = 1.3e-3 * (10.0 / 3) * (2 * 0.4 + 2);
  expect_figures(summary, 2400, 0.5 * 10 * inner * (std::numbers::pi / 4), inner);
  expect_vector(summary["probes"][0]["displacement"], {inner, 0, 0}, same * inner);
  expect_vector(summary["probes"][1]["displacement"], {outer, 0, 0}, same * inner);
  expect_vector(summary["results"]["reactions"][0]["force"], {-5, -5, 0}, equilibrium * 5);
}

TEST_F(Examples, TwoMaterialBarIsExact) {
  const json summary = summary_of("two_material_bar");
  constexpr double joint = 10e6 / (54.0e9 + 2 * 27.8e9);
  constexpr double end = joint + 10e6 / (3.19e9 + 2 * 0.899e9);
  expect_figures(summary, 66, 0.5 * 10e6 * end, end);
  expect_vector(summary["probes"][0]["displacement"], {joint, 0, 0}, 1e-12 * end);
  expect_vector(summary["probes"][1]["displacement"], {end, 0, 0}, 1e-12 * end);
  ASSERT_EQ(summary["materials"].size(), 2u);
  EXPECT_EQ(summary["materials"][1]["patches"], json::array({1}));
}

TEST_F(Examples, PlateWithHoleHasItsFigures) {
  const json summary = summary_of("plate_with_hole");
  expect_figures(summary, 4320, 0.83927176566, 6.77986211145e-5);
  EXPECT_NEAR(at(summary, "/probes/0/stress/0") / 315.272530e6, 1, same);
  expect_vector(summary["results"]["reactions"][0]["force"], {-25e3, 0, 0}, equilibrium * 25e3);
}

TEST_F(Examples, CookHasItsFigures) {
  const json summary = summary_of("cook");
  expect_figures(summary, 7176, 6.0083116062, 31.4404428703);
  expect_vector(summary["probes"][0]["displacement"], {-10.6912127, 23.9600351, 0}, same * 24);
  expect_vector(summary["results"]["reactions"][0]["force"], {0, -0.5, 0}, equilibrium);
}

TEST_F(Examples, Le10HasItsFigures) {
  const json summary = summary_of("le10");
  expect_figures(summary, 9662, 185.370497542, 0.207824008244e-3);
  EXPECT_NEAR(at(summary, "/probes/0/stress/1") / -5.39040503e6, 1, same);
  EXPECT_EQ(summary["supports"][2]["edges"], json::array({"0:east+back", "1:east+front"}));
  EXPECT_TRUE(summary["supports"][2]["faces"].empty());
  // The line carries the pressure on the plate between the ellipses.
  constexpr double area = std::numbers::pi / 4 * (3.25 * 2.75 - 2);
  expect_vector(summary["results"]["reactions"][2]["force"], {0, 0, area * 1e6}, equilibrium * area * 1e6);
}

TEST_F(Examples, ChairStandHasItsFigures) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const json summary = summary_of("chair_stand");
  expect_figures(summary, 7609, 0.0252930673, 0.317274224e-3);
  EXPECT_EQ(summary["model"]["left_handed_patches"].size(), 9u);
  expect_vector(summary["results"]["reactions"][1]["force"], {0, 0, 159.903}, equilibrium * 159.903);
}

TEST_F(Examples, ChairStandFromSolidsHasItsFigures) {
  ISOPATCH_NEEDS_DATA("chair_stand/solids");
  const json summary = summary_of("chair_stand_solids");
  expect_figures(summary, 26992, 0.0254077682, 0.318702719e-3);
  EXPECT_EQ(at(summary, "/model/patches"), 9);
  EXPECT_EQ(at(summary, "/model/interfaces"), 10);
  expect_vector(summary["results"]["reactions"][1]["force"], {0, 0, 159.903}, equilibrium * 159.903);
  // Finite elements, 69,719 nodes: W, and the mean sag of the bore, which a uniform traction makes 2 W / F.
  const double energy = at(summary, "/results/internal_energy");
  EXPECT_NEAR(energy / 25.409e-3, 1, 1e-2);
  EXPECT_NEAR(2 * energy / 159.903 / 0.31781e-3, 1, 1e-2);
}

TEST_F(Examples, ChairStandWithRingAndPinHasItsFigures) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const json summary = summary_of("chair_stand_a");
  expect_figures(summary, 8427, 0.0184364163, 0.23382422e-3);
  EXPECT_EQ(at(summary, "/model/patches"), 12);
  EXPECT_EQ(at(summary, "/model/interfaces"), 15);
  EXPECT_EQ(at(summary, "/model/bodies"), 1);
  EXPECT_NEAR(at(summary, "/loads/0/area"), 1578.5e-6, 0.05e-6);
  expect_vector(summary["results"]["reactions"][1]["force"], {0, 0, 157.848107}, 1e-6);
}

TEST_F(Examples, PipeJointHasLamesStressesFarFromTheJoint) {
  const json summary = summary_of("pipe_joint");
  expect_figures(summary, 12210, 0.505237002, 0.169396526e-3);
  // A closed pipe of radii 20 and 24 mm under 10 MPa.
  constexpr double axial = 10e6 * 400 / (576 - 400);
  constexpr double hoop_inside = 10e6 * (576 + 400) / (576 - 400);
  constexpr double radial_displacement = 0.020 / 120e9 * (hoop_inside - 0.34 * (axial - 10e6));
  const json& inside = summary["probes"][0];
  EXPECT_NEAR(inside["displacement"][1].get<double>() / radial_displacement, 1, 1e-4);
  EXPECT_NEAR(inside["stress"][0].get<double>() / hoop_inside, 1, 1e-3);
  EXPECT_NEAR(inside["stress"][1].get<double>() / -10e6, 1, 1e-3);
  EXPECT_NEAR(inside["stress"][2].get<double>() / axial, 1, 1e-3);
  EXPECT_NEAR(summary["probes"][1]["stress"][0].get<double>() / (2 * axial), 1, 1e-3);
  EXPECT_EQ(at(summary, "/model/interfaces"), 24);
  const json& clamp = summary["results"]["reactions"][0]["force"];
  EXPECT_NEAR(clamp[0].get<double>(), -500, 1e-6);
  EXPECT_NEAR(clamp[2].get<double>(), -6283.185307, 1e-5);
}

// The link's rows of p = 2, refine = 0 and 1.
TEST_F(Examples, CouplingComparisonHasItsFirstRows) {
  const fs::path study = fs::path(ISOPATCH_SOURCE_DIR) / "examples/coupling_comparison/study.toml";
  std::ostringstream out;
  std::ostringstream err;
  ASSERT_EQ(
      app::run_program({"compare", study.string(), "--output", folder_.string(), "--quiet", "--levels", "2",
                        "--condition", "--set", "discretization.refine=0", "--set", "solver.method=cholmod"},
                       {out, err, false, false, true}),
      0)
      << err.str();
  const json levels = json::parse(read_file(folder_ / "compare.json")).at("levels");
  ASSERT_EQ(levels.size(), 2u);
  const auto expect_row = [](const json& run, int unknowns, std::int64_t nonzeros, double condition) {
    EXPECT_EQ(run.at("dofs"), unknowns);
    EXPECT_EQ(run.at("matrix_nonzeros"), nonzeros);
    EXPECT_NEAR(at(run, "/condition") / condition, 1, 1e-3);
  };
  expect_row(levels[0]["elimination"], 567, 63423, 275492);
  expect_row(levels[0]["lagrange"], 1215, 73323, 360648);
  expect_row(levels[1]["elimination"], 1536, 250488, 1622044);
  expect_row(levels[1]["lagrange"], 2688, 273768, 2035568);
  for (const json& level : levels)
    for (const char* what : {"displacement", "internal_energy", "multipliers"})
      EXPECT_LT(level["difference"][what].get<double>(), 1e-11) << what;
}

TEST_F(Examples, TerrificHasItsFiguresAtDegreeTwo) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  const json summary = summary_of("terrific", {"--set", "discretization.degree=2"});
  expect_figures(summary, 14922, 68.5754656, 6.83615342e-3);
  EXPECT_NEAR(at(summary, "/supports/0/area"), 2.2521e-3, 1e-7);
  EXPECT_NEAR(at(summary, "/loads/0/area"), 2.25115e-3, 1e-8);
  EXPECT_EQ(summary["supports"][0]["faces"], json::array({"0:back", "1:back", "2:south"}));
  EXPECT_EQ(summary["model"]["patches_not_certified"], json::array({5, 8}));
}

}  // namespace
}  // namespace isopatch::verification
