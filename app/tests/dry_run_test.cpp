#include <fmt/format.h>

#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

TEST_F(Program, InfoOfAStudyShowsWhereItsConditionsAre) {
  ASSERT_EQ(run({"info", study()}), 0) << err_;
  EXPECT_THAT(out_,
              HasSubstr("supports\n  support 1 (guides): roller on x_min, y_min, z_min (5 faces), 5 m^2\n"));
  EXPECT_THAT(out_, HasSubstr("loads\n  load 1: traction on x_max (1 face), 1 m^2, in all ("));
  EXPECT_THAT(out_, HasSubstr("probes\n  end: patch 1, "));
  EXPECT_THAT(out_, HasSubstr("to be solved with 2 elements and 54 control points"));
  ASSERT_EQ(run({"info", study(), "--json", "--set", "model.orientation_seed=3"}), 0) << err_;
  const json seen = json::parse(out_);
  ASSERT_EQ(run({"run", study(), "-q", "--set", "model.orientation_seed=3"}), 0) << err_;
  const json solved = json::parse(read_file(results() / "summary.json"));
  EXPECT_EQ(seen["supports"], solved["supports"]);
  EXPECT_EQ(seen["loads"], solved["loads"]);
  EXPECT_EQ(seen["probes"][0]["parameter"], solved["probes"][0]["parameter"]);
}

TEST_F(Program, InfoOfAStudyFailsAsTheRunWould) {
  // The model is shown all the same: its faces are what the study is mended with.
  const auto refused = [&](const std::string& text, int code, const std::string& says) {
    EXPECT_EQ(run_text(text), code);
    const std::string of_run = err_.substr(err_.find("error: "));
    EXPECT_THAT(of_run, HasSubstr(says));
    EXPECT_EQ(run({"info", study()}), code);
    EXPECT_EQ(err_.substr(err_.find("error: ")), of_run);
    EXPECT_THAT(out_, HasSubstr("boundary faces"));
    EXPECT_EQ(run({"info", study(), "--json"}), code);
    EXPECT_TRUE(json::parse(out_).contains("boundary_faces"));
  };
  refused(replaced(bar, "[\"x_max\"]", "[\"x_mx\"]"), 2, "no boundary is named \"x_mx\"");
  refused(replaced(bar, "point = [2, 1, 1]", "point = [3, 1, 1]"), 2, "outside the part");
  refused(replaced(bar, "faces = [\"x_min\", \"y_min\", \"z_min\"]", "faces = [\"y_min\", \"z_min\"]"), 1,
          "translation");
  refused(bar + "[[support]]\nfaces = [\"x_min\"]\ndisplacement = [1, \"free\", \"free\"]\n", 1,
          "support 1 (guides)");
  refused(bar + "[[material]]\npatches = [1]\nname = \"steel\"\n", 2, "already has the material");
}

TEST_F(Program, InfoPassesNoModelThatARunRefuses) {
  // Two bricks that meet at x = 1. Weights 1, 1.001, 1 across the second one's face move its points by up to
  // 1e-4, which the tolerance allows.
  const std::string head = "700 1 0 0\n3 1\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n2 2\n0 0 1 1\n";
  const std::string plain =
      "0 0 0 1  1 0 0 1  0 .5 0 1  1 .5 0 1  0 1 0 1  1 1 0 1\n"
      "0 0 1 1  1 0 1 1  0 .5 1 1  1 .5 1 1  0 1 1 1  1 1 1 1\n";
  const auto weighted = [](double w) {
    return fmt::format(
        "1 0 0 1  2 0 0 1  {0} {1} 0 {0}  {2} {1} 0 {0}  1 1 0 1  2 1 0 1\n"
        "1 0 1 1  2 0 1 1  {0} {1} {0} {0}  {2} {1} {0} {0}  1 1 1 1  2 1 1 1\n",
        w, w / 2, 2 * w);
  };
  const std::string file = (folder_ / "weights.g2").string();
  write_file(file, head + plain + head + weighted(1.001));
  const std::string text = R"([model]
file = "weights.g2"
same_point = 1e-3
near_miss = 1e-2
[[material]]
name = "steel"
[[support]]
faces = ["0:west"]
displacement = [0, 0, 0]
)";
  EXPECT_EQ(run_text(text), 2);
  EXPECT_THAT(err_, HasSubstr("weights of faces 0:east and 1:west are not proportional"));
  EXPECT_EQ(run({"info", study()}), 2);
  EXPECT_THAT(err_, HasSubstr("weights of faces 0:east and 1:west are not proportional"));
  EXPECT_THAT(out_, HasSubstr("2 patches, 1 interface,"));
  write_file(file, head + plain + head + weighted(1 + 2e-7));
  EXPECT_EQ(run({"info", file}), 2);
  EXPECT_THAT(err_, HasSubstr("not proportional"));
  EXPECT_THAT(out_, HasSubstr("2 patches, 1 interface,"));
  write_file(file, head + plain + head + weighted(1));
  EXPECT_EQ(run({"info", file}), 0) << err_;
}

}  // namespace
}  // namespace isopatch::app
