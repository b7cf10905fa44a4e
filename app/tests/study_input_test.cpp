#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

#include "app/base/choices.hpp"
#include "app/study/file_kind.hpp"
#include "app/study/generated_models.hpp"
#include "app/study/parse_study.hpp"
#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

const std::string after_model =
    "[[material]]\nname = \"steel\"\n[[support]]\nfaces = [\"x_min\"]\nsymmetry = true\n";

Study study_with(const std::string& model_and_more) {
  return parse_study(model_and_more + after_model, "folder/study.toml");
}

std::string refusal_of(const std::string& load) {
  try {
    study_with("[model]\ngenerate = \"box\"\n" + load);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(StudyInput, AModelHasOneSource) {
  const Study box =
      study_with("[model]\ngenerate = \"box\"\nlength_unit = \"mm\"\nsize = [1, \"2 mm\", 3]\n");
  const auto& generated = std::get<GeneratedInput>(box.model.source);
  EXPECT_EQ(generated.length_unit, 1e-3);
  EXPECT_EQ(std::get<geometry::BoxOptions>(generated.dimensions).size, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(generated_patches(generated.dimensions).patches.size(), 1u);
  const Study file = study_with("[model]\nfile = \"a.xml\"\n");
  EXPECT_EQ(std::get<PatchFile>(file.model.source), (PatchFile{"folder/a.xml", 1}));
  const Study solids =
      study_with("[model]\nblocks = [\"a.xml\", \"b.STEP\"]\n[parameterization]\nmethod = \"paper\"\n");
  const auto& blocks = std::get<BlocksInput>(solids.model.source);
  EXPECT_THAT(blocks.files.files, testing::ElementsAre("folder/a.xml", "folder/b.STEP"));
  EXPECT_EQ(blocks.options.method, segmentation::ParameterizationMethod::paper);
  EXPECT_TRUE(std::holds_alternative<BlocksInput>(study_with("[model]\nfile = \"part.STP\"\n").model.source));
}

TEST(StudyInput, EveryGeneratedModelIsItsDimensions) {
  std::size_t kinds = 0;
  for (const GeneratedModel& model : generated_models()) {
    const GeneratedDimensions dimensions = model.read({}, {}, 1);
    EXPECT_EQ(dimensions.index(), kinds++) << model.name;
    EXPECT_FALSE(generated_patches(dimensions).boundaries.empty()) << model.name;
  }
  EXPECT_EQ(kinds, std::variant_size_v<GeneratedDimensions>);
}

TEST(StudyInput, ALoadIsOneOfAClosedSetWithWhereItActs) {
  const Study study = study_with(
      "[model]\ngenerate = \"box\"\n[[load]]\npressure = 3\nfaces = [\"x_max\"]\n"
      "[[load]]\npatches = [0]\ngravity = [0, 0, -9.81]\nname = \"weight\"\n");
  EXPECT_EQ(kind_name(study.loads[0]), "pressure");
  ASSERT_NE(faces_of(study.loads[0]), nullptr);
  EXPECT_THAT(faces_of(study.loads[0])->faces, testing::ElementsAre("x_max"));
  EXPECT_EQ(patches_of(study.loads[0]), nullptr);
  EXPECT_EQ(kind_name(study.loads[1]), "gravity");
  EXPECT_EQ(faces_of(study.loads[1]), nullptr);
  ASSERT_NE(patches_of(study.loads[1]), nullptr);
  EXPECT_THAT(patches_of(study.loads[1])->ranges, testing::ElementsAre(std::pair(0, 0)));
  EXPECT_EQ(study.loads[1].name, "load 2 (weight)");
  EXPECT_EQ(study.loads[1].key, "weight");
  EXPECT_EQ(kind_name(study.supports[0]), "symmetry");
}

TEST(StudyInput, AKeyThatDoesNotBelongToTheLoadIsRefusedWhereItStands) {
  EXPECT_EQ(refusal_of("[[load]]\nfaces = [\"x_max\"]\ngravity = [0, 0, 1]\n"),
            "folder/study.toml:4:9: [[load]]: gravity acts in patches, not on faces; use patches");
  EXPECT_EQ(refusal_of("[[load]]\nfaces = [\"x_max\"]\npressure = 1\npatches = [0]\n"),
            "folder/study.toml:6:11: [[load]]: pressure acts on faces, not in patches; use faces");
  EXPECT_THAT(refusal_of("[[load]]\nfaces = [\"x_max\"]\npressure = 1\ntraction = [1, 0, 0]\n"),
              HasSubstr("needs exactly one of traction"));
  EXPECT_THAT(refusal_of("[[load]]\npressure = 1\n"), HasSubstr("which faces are loaded?"));
  EXPECT_THAT(refusal_of("[[support]]\nfaces = [\"x_min\"]\nsymmetry = true\ndisplacement = [0, 0, 0]\n"),
              HasSubstr("folder/study.toml:6:16: [[support]] has both a displacement and symmetry"));
  EXPECT_THAT(refusal_of("[[support]]\nfaces = [\"x_min\"]\nsymmetry = true\nnormal_displacement = 1\n"),
              HasSubstr("normal_displacement needs roller = true"));
}

// What is wrong with a whole study.
std::string refusal_of_study(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_study(text, "s.toml", overrides);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(StudyInput, MaterialsSayWhatTheyLack) {
  const auto of = [](const std::string& keys) {
    return refusal_of_study("[model]\ngenerate = \"box\"\n[[material]]\n" + keys +
                            "[[support]]\nfaces = [\"x_min\"]\nsymmetry = true\n");
  };
  EXPECT_THAT(of("density = 1\n"), HasSubstr("s.toml:3:1: [[material]] needs elastic constants"));
  EXPECT_THAT(of("name = \"stel\"\n"),
              HasSubstr("no material named \"stel\" (did you mean 'steel'?); known: "));
  EXPECT_THAT(of("young = 1e9\npoisson = 0.3\nlame = { lambda = 1e9, mu = 1e9 }\n"),
              HasSubstr("has both lame and young or poisson; keep one"));
  EXPECT_THAT(of("young = 1e9\n"), HasSubstr("[[material]] has young but lacks poisson"));
  EXPECT_THAT(of("poisson = 0.3\n"), HasSubstr("[[material]] has poisson but lacks young"));
  EXPECT_THAT(of("lame = { lambda = -1e9, mu = 1e9 }\n"), HasSubstr("s.toml:3:1: "));
}

TEST(StudyInput, ModelsHaveOneSourceAndOnlyWhatBelongsToIt) {
  const auto of = [](const std::string& keys) { return refusal_of_study("[model]\n" + keys + after_model); };
  EXPECT_THAT(of(""), HasSubstr("[model] needs either file = "));
  EXPECT_THAT(of("generate = \"box\"\nfile = \"a.xml\"\n"), HasSubstr("[model] needs either file = "));
  EXPECT_THAT(of("generate = \"box\"\npairs = \"p.txt\"\n"),
              HasSubstr("pairs says how blocks meet, but [model] has no blocks"));
  EXPECT_THAT(of("generate = \"box\"\nsame_point = 1e-3\nnear_miss = 1e-3\n"),
              HasSubstr("near_miss must be above same_point"));
  EXPECT_THAT(of("file = \"a.xml\"\n[parameterization]\ndegree = 4\n"),
              HasSubstr("[parameterization] is for solids, but [model] has patches already"));
  EXPECT_THAT(of("file = \"a.xml\"\n[segmentation]\nbeam = 4\n"),
              HasSubstr("[segmentation] is for solids, but [model] has patches already"));
  EXPECT_THAT(of("file = \"\"\n"), HasSubstr("the path is empty"));
  EXPECT_THAT(of("file = \"${open\"\n"), HasSubstr("'${' without '}'"));
  EXPECT_THAT(of("generate = \"bax\"\n"), HasSubstr("unknown value \"bax\" (did you mean 'box'?)"));
}

TEST(StudyInput, SelectionsAndVectorsSayWhatTheyExpect) {
  const auto of = [](const std::string& rest) {
    return refusal_of_study("[model]\ngenerate = \"box\"\n" + rest + "\n" + after_model);
  };
  const std::string load = "[[load]]\npressure = 1\n", weight = "[[load]]\ngravity = [0, 0, 1]\n";
  EXPECT_THAT(of(load + "faces = []"), HasSubstr("faces is empty: name at least one"));
  EXPECT_THAT(of(weight + "patches = []"), HasSubstr("patches is empty"));
  for (const char* range : {"3-1", "1-", "- 2", "1 2"})
    EXPECT_THAT(of(weight + "patches = \"" + range + "\""),
                HasSubstr("patches: expected \"all\", numbers from 0, ranges such as"))
        << range;
  EXPECT_THAT(of("[[support]]\nfaces = [\"x_max\"]\ndisplacement = [0, 0]"),
              HasSubstr("displacement: expected 3 components, got 2"));
  EXPECT_THAT(of("[discretization]\ndegree = [2, 2]"), HasSubstr("degree: expected one number or 3, got 2"));
  EXPECT_THAT(of("[[load]]\npressure = 1\nwhere = { normal = [0, 0, 0] }"),
              HasSubstr("is a direction; it cannot be zero"));
  EXPECT_THAT(of("[load]\npressure = 1"), HasSubstr("load: write [[load]] with two brackets"));
}

TEST(StudyInput, OverridesSayWhichKeyTheyMissed) {
  const std::string study = "[model]\ngenerate = \"box\"\nsize = [1, 2, 3]\n" + after_model;
  const auto of = [&](const std::string& assignment) { return refusal_of_study(study, {assignment}); };
  EXPECT_EQ(of("model.size.1=7"), "accepted");
  EXPECT_THAT(of("model.size"), HasSubstr("--set model.size: expected key=value, for example"));
  EXPECT_THAT(of("model..size=1"), HasSubstr("a key is empty"));
  EXPECT_THAT(of("model.size.x=1"), HasSubstr("'x' is no index of an array of 3 (they count from 0)"));
  EXPECT_THAT(of("model.size.3=1"), HasSubstr("'3' is no index of an array of 3"));
  EXPECT_THAT(of("model.generate.name=1"), HasSubstr("'name' lies inside"));
}

TEST(StudyInput, AMisspeltKindIsFoundBeforeItIsMissed) {
  EXPECT_THAT(refusal_of("[[load]]\nfaces = [\"x_max\"]\npresure = 1\n"),
              HasSubstr("did you mean 'pressure'?"));
  EXPECT_THAT(refusal_of("[[load]]\npatches = [0]\ngravty = [0, 0, 1]\n"),
              HasSubstr("did you mean 'gravity'?"));
  EXPECT_THAT(refusal_of("[[support]]\nfaces = [\"x_min\"]\nsymetry = true\n"),
              HasSubstr("did you mean 'symmetry'?"));
}

TEST(StudyInput, WordsAreTakenByNameAndNotByTheirOrder) {
  enum class Fruit { pear, apple };
  const Choices<Fruit> fruits = {{"apple", Fruit::apple}, {"pear", Fruit::pear}, {"pomme", Fruit::apple}};
  EXPECT_EQ(*find_choice(fruits, "pear"), Fruit::pear);
  EXPECT_EQ(*find_choice(fruits, "pomme"), Fruit::apple);
  EXPECT_EQ(find_choice(fruits, "plum"), nullptr);
  EXPECT_EQ(name_of(fruits, Fruit::apple), "apple");
  EXPECT_EQ(quoted_list(names(fruits)), "\"apple\", \"pear\" or \"pomme\"");
  const auto solver = [](const std::string& key, const std::string& word) {
    return parse_study("[model]\ngenerate = \"box\"\n" + after_model, "s.toml",
                       {"solver." + key + "=" + word})
        .options.solver;
  };
  EXPECT_EQ(solver("preconditioner", "multigrid").preconditioner, solvers::Preconditioner::multigrid);
  EXPECT_EQ(solver("preconditioner", "block_jacobi").preconditioner, solvers::Preconditioner::block_jacobi);
  EXPECT_EQ(solver("operator", "auto").form, solvers::Operator::automatic);
  EXPECT_EQ(solver("operator", "assembled").form, solvers::Operator::assembled);
  EXPECT_EQ(solver("operator", "matrix_free").form, solvers::Operator::matrix_free);
  EXPECT_EQ(solver("method", "minres").method, solvers::Method::minres);
}

TEST_F(Program, KnowsAFileByItsEndingInWhateverCase) {
  for (const auto& [name, kind] :
       {std::pair("a.toml", FileKind::study), std::pair("a.TOML", FileKind::study),
        std::pair("a.h5", FileKind::results), std::pair("a.G2", FileKind::patches),
        std::pair("a.mesh", FileKind::patches), std::pair("a.Step", FileKind::cad),
        std::pair("a.p21", FileKind::cad), std::pair("a.IGS", FileKind::cad),
        std::pair("a.brep", FileKind::cad), std::pair("a.OFF", FileKind::polyhedra),
        std::pair("none.xml", FileKind::patches), std::pair("a.STL", FileKind::triangles),
        std::pair("a.msh", FileKind::unknown), std::pair("a", FileKind::unknown)})
    EXPECT_EQ(kind_of(name), kind) << name;
  write_file(folder_ / "solid.XML", "<xml><Solid id=\"0\"></Solid></xml>");
  write_file(folder_ / "patch.xml", "<xml><Geometry type=\"TensorBSpline3\"/></xml>");
  EXPECT_EQ(kind_of(folder_ / "solid.XML"), FileKind::gismo_solids);
  EXPECT_EQ(kind_of(folder_ / "patch.xml"), FileKind::patches);
  EXPECT_TRUE(holds_solids(folder_ / "solid.XML"));
  // Commands go by it.
  write_file(folder_ / "STUDY.TOML", bar);
  ASSERT_EQ(run({"info", (folder_ / "STUDY.TOML").string()}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("probes\n  end: patch 1, "));
}

}  // namespace
}  // namespace isopatch::app
