#include "app/tests/program_fixture.hpp"

#include "geometry/base/larger.hpp"

namespace isopatch::app {
namespace {

TEST_F(Program, SaysWhatEverySupportAndLoadCaught) {
  ASSERT_EQ(run_text(replaced(bar, "young = 1e9", "young = 1e9\ndensity = 2") +
                     "[[load]]\nname = \"weight\"\npatches = 1\ngravity = [0, 0, -1]\n"),
            0)
      << err_;
  const json summary = json::parse(read_file(results() / "summary.json"));
  const json& guides = summary["supports"][0];
  EXPECT_EQ(guides["name"], "guides");
  EXPECT_EQ(guides["kind"], "roller");
  EXPECT_THAT(guides["given"], testing::ElementsAre("x_min", "y_min", "z_min"));
  EXPECT_THAT(guides["faces"], testing::ElementsAre("0:west", "0:south", "0:front", "1:south", "1:front"));
  EXPECT_NEAR(guides["area"], 5, 1e-13);
  ASSERT_EQ(summary["loads"].size(), 2u);
  EXPECT_EQ(summary["loads"][0]["kind"], "traction");
  EXPECT_THAT(summary["loads"][0]["faces"], testing::ElementsAre("1:east"));
  EXPECT_NEAR(summary["loads"][0]["area"], 1, 1e-13);
  EXPECT_EQ(summary["loads"][1]["kind"], "gravity");
  EXPECT_THAT(summary["loads"][1]["patches"], testing::ElementsAre(1));
  EXPECT_NEAR(summary["loads"][1]["volume"], 1, 1e-13);
  EXPECT_NEAR(summary["loads"][0]["total"][0], 1e7, 1e-5);
  EXPECT_NEAR(summary["loads"][1]["total"][2], -2, 1e-12);
  EXPECT_THAT(
      out_,
      HasSubstr("  support           support 1 (guides): roller on x_min, y_min, z_min (5 faces), 5 m^2\n"));
  EXPECT_THAT(out_, HasSubstr("  load              load 1: traction on x_max (1 face), 1 m^2\n"));
  EXPECT_THAT(out_, HasSubstr("  load              load 2 (weight): gravity in 1 patch, 1 m^3\n"));
}

TEST_F(Program, NamesFacesInTheInputsNamingAndWarnsOfThoseMissedByLittle) {
  const std::string text = replaced(bar, "faces = [\"x_max\"]",
                                    "where = { box = { min = [1.9998, 0, 0], max = [2.1, 1, 1] }, "
                                    "tolerance = \"0.1 mm\" }");
  ASSERT_EQ(run_text(text, {"--set", "model.orientation_seed=3"}), 0) << err_;
  const json summary = json::parse(read_file(results() / "summary.json"));
  ASSERT_EQ(run({"info", study(), "--set", "model.orientation_seed=3", "--json"}), 0);
  EXPECT_EQ(summary["loads"][0]["faces"], json::parse(out_)["boundaries"]["x_max"]);
  EXPECT_THAT(summary["warnings"], testing::IsEmpty());
  const std::string tilted = replaced(bar, "faces = [\"x_max\"]",
                                      "where = { plane = { point = [2, 0, 0], normal = [1, 0, 0.0002] }, "
                                      "tolerance = \"0.1 mm\" }");
  EXPECT_EQ(run_text(tilted), 2);  // 0.2 mm away, and nothing else is nearer
  const std::string halved = replaced(tilted, "patches = [2, 1, 1]", "patches = [1, 1, 2]");
  ASSERT_EQ(run_text(halved), 0) << err_;
  EXPECT_THAT(err_,
              HasSubstr("isopatch: warning: " + study() +
                        ":13:1: load 1 leaves out 1:east (up to 200 um away); its tolerance is 100 um"));
  // And that the elements are large for the load on half of an end.
  const json warnings = json::parse(read_file(results() / "summary.json"))["warnings"];
  ASSERT_THAT(warnings, testing::SizeIs(2));
  EXPECT_THAT(warnings[0].get<std::string>(), HasSubstr("leaves out 1:east"));
}

TEST_F(Program, ListsEveryMaterialOnceWithItsPatches) {
  ASSERT_EQ(run_text((replaced(bar, "young = 1e9", "patches = 1\nyoung = 1e9") +
                      "[[material]]\npatches = 0\nname = \"steel\"\n")),
            0)
      << err_;
  const json materials = json::parse(read_file(results() / "summary.json"))["materials"];
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0]["young"], 1e9);
  EXPECT_THAT(materials[0]["patches"], testing::ElementsAre(1));
  EXPECT_EQ(materials[1]["name"], "steel");
  EXPECT_THAT(materials[1]["patches"], testing::ElementsAre(0));
  ASSERT_EQ(run_text(bar), 0) << err_;
  EXPECT_THAT(json::parse(read_file(results() / "summary.json"))["materials"][0]["patches"],
              testing::ElementsAre(0, 1));
}

TEST_F(Program, RoundOffIsPrintedAsZeroInTextsOnly) {
  // Stress and displacement across a bar without Poisson's effect are pure round-off.
  const std::string text = replaced(replaced(bar, "poisson = 0.25", "poisson = 0"), "size = [2, 1, 1]",
                                    "size = [2, 1, 1]\ndistortion = 0.2");
  ASSERT_EQ(run_text(text), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("displacement (20, 0, 0) mm, von Mises 10 +- 0 MPa"));
  EXPECT_THAT(out_, HasSubstr("reaction          (-10, 0, 0) MN"));
  const std::string file = (results() / "results.h5").string();
  ASSERT_EQ(run({"probe", file, "--point", "1,0.4,0.3"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("displacement  (0.01, 0, 0) m\n"));
  EXPECT_THAT(out_, HasSubstr("stress        xx 1e+07, yy 0, zz 0, xy 0, yz 0, zx 0 Pa\n"));
  ASSERT_EQ(run({"probe", file, "--point", "1,0.4,0.3", "--json"}), 0) << err_;
  const json values = json::parse(out_);
  double largest = 0;
  for (int i = 1; i < 6; ++i) largest = larger(largest, std::abs(values["stress"][i].get<double>()));
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 1e-5);
}

}  // namespace
}  // namespace isopatch::app
