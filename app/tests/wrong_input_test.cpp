#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

// Each message leads to the cause.

TEST_F(Program, AMissingQuoteIsFoundWhereItsStringBegins) {
  EXPECT_EQ(run_text(replaced(bar, "name = \"guides\"", "name = \"guides")), 2);
  EXPECT_THAT(err_, HasSubstr("study.toml:10:8: not valid TOML: a quote is missing on this line"));
  EXPECT_EQ(run_text(replaced(bar, "[\"x_max\"]", "[\"x_max]  # \"the end\"")), 2);
  EXPECT_THAT(err_, HasSubstr("study.toml:14:29: not valid TOML: a quote is missing"));
  EXPECT_EQ(run_text(replaced(bar, "\"box\"", "'box")), 2);
  EXPECT_THAT(err_, HasSubstr("study.toml:3:12: not valid TOML: a quote is missing"));
  // Other mistakes keep their own words.
  EXPECT_EQ(run_text(replaced(bar, "young = ", "young == 7  # \"x")), 2);
  EXPECT_THAT(err_, HasSubstr("study.toml:7:"));
  EXPECT_THAT(err_, testing::Not(HasSubstr("quote")));
}

TEST_F(Program, WhatIsNoStudyIsNamed) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  const std::string stored = (results() / "results.h5").string();
  for (const char* command : {"run", "compare"}) {
    EXPECT_EQ(run({command, stored}), 2);
    EXPECT_THAT(err_, HasSubstr(stored + " holds results, not a study; `isopatch info " + stored + "`"));
    for (const char* name :
         {"model.g2", "model.mesh", "model.xml", "part.step", "part.iges", "part.off", "part.stl"}) {
      const std::string file = (folder_ / name).string();
      write_file(file, "700 1 0 0\n");
      EXPECT_EQ(run({command, file}), 2) << name;
      EXPECT_THAT(err_,
                  HasSubstr(file + " is a model, not a study; `isopatch info " + file + "` describes it"));
    }
  }
  write_file(folder_ / "model.txt", "<?xml version=\"1.0\"?>\n<xml/>\n");
  EXPECT_EQ(run({"run", (folder_ / "model.txt").string()}), 2);
  EXPECT_THAT(err_, HasSubstr("is a model, not a study"));
}

TEST_F(Program, PlainNumbersOfAPointAreSaidToBeMetres) {
  const std::string says =
      "The part lies between (0, 0, 0) mm and (2000, 1000, 1000) mm; numbers without a unit are metres";
  EXPECT_EQ(run_text(replaced(bar, "point = [2, 1, 1]", "point = [2000, 1000, 1000]")), 2);
  EXPECT_THAT(err_, HasSubstr("outside the part"));
  EXPECT_THAT(err_, HasSubstr(says));
  ASSERT_EQ(run_text(bar, {"-q"}), 0) << err_;
  const std::string stored = (results() / "results.h5").string();
  EXPECT_EQ(run({"probe", stored, "--point", "2000,1000,1000"}), 2);
  EXPECT_THAT(err_, HasSubstr(says));
  EXPECT_EQ(run({"probe", stored, "--point", "2.5,1,1"}), 2);
  EXPECT_THAT(err_, testing::Not(HasSubstr("metres"))) << "near the part the unit is not the mistake";
}

TEST_F(Program, ADecimalCommaIsNamed) {
  EXPECT_EQ(run_text(replaced(bar, "size = [2, 1, 1]", "size = [2, 1, \"1,25 mm\"]")), 2);
  EXPECT_THAT(err_, HasSubstr("'1,25 mm' has a decimal comma; numbers are written with a point"));
}

TEST_F(Program, FormatsThatAreNotReadAreNamedWithThoseThatAre) {
  for (const auto& [name, text, says] :
       {std::tuple("a.tri", "solid a\nfacet normal 0 0 1\n", "an STL triangulation"),
        std::tuple("a.inp", "*Heading\n*Node\n1, 0, 0, 0\n", "an input file of Abaqus"),
        std::tuple("a.msh", "$MeshFormat\n2.2 0 8\n", "a Gmsh mesh"),
        std::tuple("a.dat", "hello\n", "the format is unknown")}) {
    const std::string file = (folder_ / name).string();
    write_file(file, text);
    for (const char* command : {"info", "run"}) {
      const std::string wanted = std::string(command) == "run" ? study() : file;
      write_file(study(), replaced(bar, "generate = \"box\"\nsize = [2, 1, 1]\npatches = [2, 1, 1]",
                                   "file = \"" + std::string(name) + "\""));
      EXPECT_EQ(run({command, wanted}), 2) << name;
      EXPECT_THAT(err_, HasSubstr(says));
      EXPECT_THAT(err_, HasSubstr("supported are G+Smo XML"));
      EXPECT_THAT(err_, HasSubstr("Formats of solids: STEP (.step, .stp, .p21), IGES"));
      EXPECT_THAT(err_, HasSubstr("of triangles: STL (.stl)"));
    }
  }
}

TEST_F(Program, AValueThatTheShellHasTakenQuotesFromIsNamed) {
  EXPECT_EQ(run({"run", study(), "--set", "load.0.traction=[20 MPa, 0, 0]"}), 2);
  EXPECT_THAT(
      err_,
      HasSubstr("--set load.0.traction=[20 MPa, 0, 0]: the value is no valid TOML; does the shell take"));
  EXPECT_EQ(run({"run", study(), "-q", "--set", "load.0.traction=[\"20 Pa\", 0, 0]"}), 0) << err_;
  EXPECT_EQ(run({"run", study(), "-q", "--set", "title=a bar"}), 0) << "plain text needs no quotes: " << err_;
}

TEST_F(Program, ANearMissAdvisesAKeyThatHelps) {
  const std::string cube = "700 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n";
  write_file(folder_ / "gap.g2", cube + "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n" + cube +
                                     "1.001 0 0 2 0 0 1.001 1 0 2 1 0 1.001 0 1 2 0 1 1.001 1 1 2 1 1\n");
  const std::string text = replaced(
      replaced(
          replaced(bar, "generate = \"box\"\nsize = [2, 1, 1]\npatches = [2, 1, 1]", "file = \"gap.g2\""),
          "[\"x_min\", \"y_min\", \"z_min\"]", "[\"0:west\", \"0:south\", \"0:front\"]"),
      "[\"x_max\"]", "[\"1:east\"]");
  EXPECT_EQ(run_text(text), 2);
  EXPECT_THAT(err_, HasSubstr("raise same_point (in a study: model.same_point) above 0.00041"));
  EXPECT_EQ(run_text(text, {"--set", "model.same_point=5e-4"}), 0) << err_;
}

}  // namespace
}  // namespace isopatch::app
