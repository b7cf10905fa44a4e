#include "app/study/parse_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

#include "app/problem/build_problem.hpp"
#include "app/study/study_documentation.hpp"
#include "app/study/study_path.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/measures.hpp"

namespace isopatch::app {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string model = "[model]\ngenerate = \"box\"\n";
const std::string material = "[[material]]\nname = \"steel\"\n";
const std::string support = "[[support]]\nfaces = [\"x_min\"]\ndisplacement = [0, 0, 0]\n";

/// The message for a study that must be refused.
std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_study(text, "a/study.toml", overrides);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Study, ReadsAWholeFile) {
  const Study study = parse_study(R"(
title = "all"
[model]
file = "patches.xml"
length_unit = "225 mm"
same_point = 1e-5
near_miss = 1e-2
same_knot = 1e-8
[discretization]
degree = [2, 3, 4]
refine = 1
elements_per_direction = 5
max_size = "3 mm"
continuity = 1
points = 6
[[material]]
patches = [0, "2-4"]
lame = { lambda = "54.0 GPa", mu = 27.8e9 }
name = "alu"
density = "2.7 g/cm^3"
[[material]]
patches = 1
young = "210 GPa"
poisson = 0.3
[[support]]
name = "clamp"
faces = ["0:back", "inner"]
where = { plane = { point = [0, 0, "1 mm"], normal = "-z" }, cylinder = { point = [1, 2, 3], axis = [0, 0, 2], radius = "5 mm" }, sphere = { centre = [0, 0, 1], radius = 2 }, box = { min = [0, 0, 0], max = [1, 1, 1] }, normal = "x", angle = "10 deg", tolerance = "0.1 mm" }
displacement = ["1 mm", "free", 0]
displacement_gradient = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
[[support]]
faces = "1:west"
roller = true
normal_displacement = "-2 um"
[[support]]
faces = ["2:west"]
symmetry = true
[[load]]
faces = ["a"]
traction = ["20 MPa", "-14 MPa", 0]
[[load]]
faces = ["a"]
pressure = "1 bar"
[[load]]
faces = ["a"]
force = [0, 0, "1 kN"]
[[load]]
patches = "0-1"
body_force = [0, 0, "1 N/mm^3"]
[[load]]
name = "weight"
gravity = [0, 0, "-9.81 m/s^2"]
[coupling]
method = "lagrange"
[solver]
method = "mumps"
tolerance = 1e-9
max_iterations = 77
memory_limit = "2 GB"
[[probe]]
name = "p"
point = ["1 mm", 0, 0]
[[probe]]
patch = 2
parameter = [0.5, 0, 1]
[output]
directory = "out"
fields = false
hdf5 = false
)",
                                  "folder/study.toml");
  EXPECT_EQ(study.title, "all");
  EXPECT_EQ(std::get<PatchFile>(study.model.source), (PatchFile{"folder/patches.xml", 0.225}));
  EXPECT_EQ(study.model.tolerance.same_point, 1e-5);
  EXPECT_EQ(study.model.tolerance.near_miss, 1e-2);
  EXPECT_EQ(study.model.tolerance.same_knot, 1e-8);
  EXPECT_EQ(study.discretization.degree, (std::array{2, 3, 4}));
  EXPECT_EQ(study.discretization.refine, 1);
  EXPECT_EQ(study.discretization.elements_per_direction, (std::array{5, 5, 5}));
  EXPECT_EQ(study.discretization.max_size, 0.003);
  EXPECT_EQ(study.discretization.continuity, 1);
  EXPECT_EQ(study.options.quadrature_points, 6);
  ASSERT_EQ(study.materials.size(), 2u);
  EXPECT_EQ(study.materials[0].material.lambda, 54e9);
  EXPECT_EQ(study.materials[0].material.mu, 27.8e9);
  EXPECT_EQ(study.materials[0].material.density, 2700);
  EXPECT_EQ(study.materials[0].material.name, "alu");
  EXPECT_THAT(study.materials[0].patches.ranges, testing::ElementsAre(std::pair(0, 0), std::pair(2, 4)));
  EXPECT_NEAR(study.materials[1].material.mu, 210e9 / 2.6, 1);
  ASSERT_EQ(study.supports.size(), 3u);
  EXPECT_EQ(study.supports[0].name, "support 1 (clamp)");
  EXPECT_THAT(study.supports[0].selection.faces, testing::ElementsAre("0:back", "inner"));
  const FaceConditions& where = *study.supports[0].selection.where;
  EXPECT_EQ(where.plane->point, Eigen::Vector3d(0, 0, 0.001));
  EXPECT_EQ(where.plane->normal, Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(where.cylinder->axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(where.cylinder->radius, 0.005);
  EXPECT_EQ(where.sphere->radius, 2);
  EXPECT_EQ(where.box->max, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(*where.normal, Eigen::Vector3d(1, 0, 0));
  EXPECT_NEAR(where.angle.degrees(), 10, 1e-13);
  EXPECT_EQ(where.tolerance, 1e-4);
  const auto& prescribed = std::get<HeldDisplacement>(study.supports[0].condition).displacement;
  EXPECT_EQ(prescribed.value[0], 0.001);
  EXPECT_FALSE(prescribed.value[1].has_value());
  EXPECT_EQ(prescribed.gradient(1, 2), 6);
  EXPECT_EQ(std::get<Roller>(study.supports[1].condition).normal_displacement, -2e-6);
  EXPECT_TRUE(std::holds_alternative<Symmetry>(study.supports[2].condition));
  ASSERT_EQ(study.loads.size(), 5u);
  EXPECT_EQ(std::get<Traction>(study.loads[0].load).value, Eigen::Vector3d(20e6, -14e6, 0));
  EXPECT_EQ(std::get<Pressure>(study.loads[1].load).value, 1e5);
  EXPECT_EQ(std::get<Force>(study.loads[2].load).value, Eigen::Vector3d(0, 0, 1000));
  EXPECT_EQ(std::get<BodyForce>(study.loads[3].load).value[2], 1e9);
  EXPECT_THAT(std::get<BodyForce>(study.loads[3].load).patches.ranges, testing::ElementsAre(std::pair(0, 1)));
  EXPECT_EQ(study.loads[4].name, "load 5 (weight)");
  EXPECT_EQ(std::get<Gravity>(study.loads[4].load).value[2], -9.81);
  EXPECT_EQ(study.options.coupling, iga::Coupling::lagrange);
  EXPECT_EQ(study.options.solver.method, solvers::Method::mumps);
  EXPECT_EQ(study.options.solver.tolerance, 1e-9);
  EXPECT_EQ(study.options.solver.max_iterations, 77);
  EXPECT_EQ(study.options.solver.memory_limit, 2e9);
  ASSERT_EQ(study.probes.size(), 2u);
  EXPECT_EQ(std::get<Eigen::Vector3d>(study.probes[0].where), Eigen::Vector3d(0.001, 0, 0));
  EXPECT_EQ(std::get<PatchParameter>(study.probes[1].where).patch, 2);
  EXPECT_EQ(study.probes[1].name, "probe 2");
  EXPECT_EQ(study.output.directory, "folder/out");
  EXPECT_FALSE(study.output.fields);
  EXPECT_FALSE(study.output.hdf5);
}

TEST(Study, UnknownKeysNameTheNearestKnownOneWithFileAndLine) {
  EXPECT_EQ(refusal(model + material + support + "[discretization]\ndegre = 3\n"),
            "a/study.toml:9:1: unknown key 'degre' in [discretization] (did you mean 'degree'?)");
  EXPECT_THAT(refusal(model + "distorsion = 0.1\n" + material + support),
              HasSubstr("a/study.toml:3:1: unknown key 'distorsion' in [model] with generate = \"box\" (did "
                        "you mean 'distortion'?)"));
  EXPECT_THAT(refusal(model + material + support + "[solvers]\n"), HasSubstr("did you mean 'solver'?"));
  EXPECT_THAT(refusal(model + material + "[[support]]\nfaces = [\"a\"]\nwhere = { plan = {} }\n"),
              HasSubstr("unknown key 'plan' in where (did you mean 'plane'?)"));
  EXPECT_THAT(refusal(model + material + "[[support]]\nfaces = [\"a\"]\nzzzzzz = 1\n"),
              HasSubstr("known: name, faces, where"));
}

TEST(Study, KeysUnderAWrongHeadingNameTheirOwn) {
  EXPECT_THAT(
      refusal(model + material + support + "fields = false\n"),
      AllOf(HasSubstr("unknown key 'fields' in [[support]]"), EndsWith("'fields' is a key of [output]")));
  EXPECT_THAT(refusal("refine = 3\n" + model + material + support),
              EndsWith("'refine' is a key of [discretization] and [[discretization.patch]]"));
  EXPECT_THAT(refusal(model + "faces = [\"a\"]\n" + material + support), Not(HasSubstr("is a key of")))
      << "too many have faces";
}

TEST(Study, SupportsThatSayTooLittleOrTooMuchAreRefused) {
  const std::string held = "[[support]]\nfaces = [\"x_min\"]\n";
  EXPECT_THAT(refusal(model + material + support + "displacement_gradient = [[1, 0, 0], [0, 1, 0]]\n"),
              EndsWith("displacement_gradient: expected 3 rows of 3 numbers"));
  EXPECT_THAT(refusal(model + material + held +
                      "displacement = [0, 0, 0]\nedges = { plane = { normal = \"z\" } }\npart = { sphere = { "
                      "radius = 1 } }\n"),
              HasSubstr("edges hold whole edges; leave out part"));
  EXPECT_THAT(refusal(model + material + held + "displacement = [0, 0, 0]\npoints = [[0, 0, 0]]\n"),
              HasSubstr("points or a line beside faces"));
  EXPECT_THAT(refusal(model + material + "[[support]]\ndisplacement = [0, 0, 0]\nline = [[0, 0, 0]]\n"),
              HasSubstr("a line needs two points or more"));
}

TEST(Study, VariablesOfPathsWithoutTheirEndAreNamed) {
  EXPECT_THAT(refusal("[model]\nfile = \"${HOME/a.g2\"\n" + material + support),
              HasSubstr("'${' without '}' in \"${HOME/a.g2\""));
}

TEST(Study, BrokenTomlSaysWhere) {
  EXPECT_THAT(refusal("[model]\nfile = \"x\nmore"), StartsWith("a/study.toml:2:"));
  EXPECT_THAT(refusal("[model]\nfile = \"x\"\nfile = \"y\"\n"), StartsWith("a/study.toml:3:"));
  EXPECT_THAT(refusal("[model\n"), HasSubstr("not valid TOML"));
  EXPECT_THAT(refusal("title = 1979-05-27\n"), HasSubstr("dates and times"));
}

TEST(Study, WrongUnitsSayWhatWasExpectedAndWhatCame) {
  const std::string load = "[[load]]\nfaces = [\"x_max\"]\n";
  EXPECT_EQ(refusal(model + material + support + load + "traction = [\"20 mm\", 0, 0]\n"),
            "a/study.toml:10:13: traction: expected a pressure such as \"20 MPa\", or a number in Pa, got "
            "\"20 mm\", which is a length");
  EXPECT_THAT(refusal(model + material + support + load + "pressure = \"20\"\n"),
              HasSubstr("got \"20\" without a unit"));
  EXPECT_THAT(refusal(model + material + support + load + "pressure = \"20 Mpa\"\n"),
              HasSubstr("did you mean 'MPa'?"));
  EXPECT_THAT(refusal(model + material + support + load + "pressure = true\n"),
              HasSubstr("expected a pressure such as"));
  EXPECT_THAT(refusal(model + material + support + load + "pressure = nan\n"), HasSubstr("must be finite"));
  EXPECT_THAT(refusal(model + material + support + load + "pressure = \"inf Pa\"\n"),
              HasSubstr("not a finite number"));
  EXPECT_THAT(refusal("[model]\nfile = \"x\"\nlength_unit = \"2 MPa\"\n" + material + support),
              HasSubstr("expected a length such as \"mm\""));
  EXPECT_THAT(refusal(model + "size = [1, \"2 Pa\", 3]\n" + material + support),
              HasSubstr("size: expected a length"));
}

TEST(Study, RangesAndMissingKeysSayWhatIsAllowed) {
  const std::string rest = model + support;
  EXPECT_THAT(refusal(rest + "[[material]]\nyoung = 1\npoisson = 0.5\n"),
              HasSubstr("poisson is 0.5; it must be above -1 and below 0.5. An incompressible material"));
  EXPECT_THAT(refusal(rest + "[[material]]\nyoung = -1\npoisson = 0.3\n"),
              HasSubstr("young is -1 Pa; it must be above 0"));
  EXPECT_THAT(refusal(rest + "[[material]]\nyoung = 1\n"), HasSubstr("has young but lacks poisson"));
  EXPECT_THAT(refusal(rest + "[[material]]\nname = \"steal\"\n"), HasSubstr("did you mean 'steel'?"));
  EXPECT_THAT(refusal(rest + "[[material]]\nlame = { lambda = 1 }\n"), HasSubstr("lame lacks the key 'mu'"));
  EXPECT_THAT(refusal(rest + "[[material]]\npatches = [-1]\nname = \"steel\"\n"),
              HasSubstr("patches: expected a whole number"));
  EXPECT_THAT(refusal(rest + "[[material]]\npatches = [\"4-2\"]\nname = \"steel\"\n"),
              HasSubstr("got \"4-2\""));
  EXPECT_THAT(refusal(rest + material + "[discretization]\ndegree = 0\n"),
              HasSubstr("degree: expected a whole number from 1 to 10, got the number 0"));
  EXPECT_THAT(refusal(rest + material + "[solver]\ntolerance = 1\n"),
              HasSubstr("tolerance is 1; it must be from 1e-14 to 0.01"));
  EXPECT_THAT(refusal(rest + material + "[solver]\nmethod = \"cholmud\"\n"),
              HasSubstr("did you mean 'cholmod'?"));
  EXPECT_THAT(refusal(material + support), HasSubstr("a/study.toml: the study lacks the key 'model'"));
  EXPECT_THAT(refusal(model + material),
              HasSubstr("the study lacks the key 'support': What holds the part."));
  EXPECT_THAT(refusal("[model]\n" + material + support), HasSubstr("needs either file"));
  EXPECT_THAT(refusal("[model]\ngenerate = \"links\"\n" + material + support),
              HasSubstr("did you mean 'link'?"));
  EXPECT_THAT(refusal(model + material + "[support]\nfaces = [\"a\"]\n"),
              HasSubstr("write [[support]] with two brackets"));
  EXPECT_THAT(refusal(model + material + "[[support]]\nfaces = [\"a\"]\n"), HasSubstr("needs displacement"));
  EXPECT_THAT(refusal(model + material + "[[support]]\nsymmetry = true\n"), HasSubstr("what is held?"));
  EXPECT_THAT(refusal(model + material + support + "[[load]]\nfaces = [\"a\"]\n"),
              HasSubstr("exactly one of traction"));
  EXPECT_THAT(refusal(model + material + support + "[[load]]\nfaces = [\"a\"]\ngravity = [0, 0, 1]\n"),
              HasSubstr("acts in patches"));
  EXPECT_THAT(refusal(model + material + support + "[[probe]]\npatch = 1\n"),
              HasSubstr("either a point, or a patch"));
}

TEST(Study, VariablesAndRelativePathsAreResolved) {
  ::setenv("ISOPATCH_TEST_FOLDER", "/data", 1);
  ::unsetenv("ISOPATCH_TEST_NONE");
  EXPECT_EQ(expand_variables("${ISOPATCH_TEST_FOLDER}/a"), "/data/a");
  EXPECT_EQ(expand_variables("${ISOPATCH_TEST_NONE:-b}/a"), "b/a");
  EXPECT_EQ(expand_variables("plain$"), "plain$");
  EXPECT_THAT(refusal("[model]\nfile = \"${ISOPATCH_TEST_NONE}/a\"\n" + material + support),
              HasSubstr("a/study.toml:2:8: the environment variable ISOPATCH_TEST_NONE is not set"));
  EXPECT_THAT(refusal("[model]\nfile = \"${open\"\n" + material + support), HasSubstr("without '}'"));
}

TEST(Study, OverridesReplaceOneValue) {
  const std::string text = model + material + support;
  const Study study = parse_study(text, "s.toml",
                                  {"discretization.refine=2", "material.0.name=titanium", "title=a = b",
                                   "support.0.displacement=['1 mm', 'free', 0]"});
  EXPECT_EQ(study.discretization.refine, 2);
  EXPECT_EQ(study.materials[0].material.name, "titanium");
  EXPECT_EQ(study.title, "a = b");
  EXPECT_EQ(std::get<HeldDisplacement>(study.supports[0].condition).displacement.value[0], 0.001);
  EXPECT_EQ(refusal(text, {"discretization.refin=2"}),
            "--set discretization.refin=2: unknown key 'refin' in [discretization] (did you mean 'refine'?)");
  EXPECT_THAT(refusal(text, {"title"}), HasSubstr("expected key=value"));
  EXPECT_THAT(refusal(text, {"material.3.name=steel"}), HasSubstr("'3' is no index of an array of 1"));
  EXPECT_THAT(refusal(text, {"model.generate.x=1"}), HasSubstr("has no keys"));
}

TEST(Study, AttachesPatchesInTheUnitsOfTheModel) {
  const std::string ring = R"([model]
generate = "cylinder"
length_unit = "mm"
inner_radius = 20
outer_radius = 30
height = 50
[[model.attach]]
name = "bore"
faces = ["inner"]
scale = [0.5, 0.5, 1]
[[model.attach]]
faces = ["top", "1:north"]
move = [0, 0, "1 cm"]
)";
  const Study study = parse_study(ring + material + support, "a/study.toml");
  ASSERT_EQ(study.model.attachments.size(), 2u);
  const geometry::MultiPatch model = load_model(study.model).model;
  ASSERT_EQ(model.patch_count(), 4) << "quarter, its filling, and one more on both";
  EXPECT_EQ(model.interfaces().size(), 4u);
  double volume = 0;
  for (const auto& patch : model.patches()) volume += geometry::volume(patch);
  EXPECT_NEAR(volume, std::numbers::pi / 4 * (9e-4 - 1e-4) * 0.06, 1e-14);
  const auto text = [&](const std::string& attach) {
    return "[model]\ngenerate = \"cylinder\"\n[[model.attach]]\n" + attach + material + support;
  };
  EXPECT_THAT(refusal(text("faces = [\"inner\"]\n")),
              HasSubstr("a/study.toml:3:1: [[model.attach]] needs move or scale"));
  EXPECT_THAT(refusal(text("scale = 2\n")), HasSubstr("lacks the key 'faces'"));
  const auto unknown = [&](const std::string& face) {
    try {
      load_model(parse_study(text("scale = 2\nfaces = [\"" + face + "\"]\n"), "a/study.toml").model);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(unknown("iner"),
              HasSubstr("a/study.toml:3:1: no boundary is named \"iner\" (did you mean 'inner'?)"));
  EXPECT_THAT(unknown("7:east"), HasSubstr("the model has patches 0 to 0"));
}

TEST(Study, EveryExampleIsRead) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(ISOPATCH_SOURCE_DIR) / "examples")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(std::filesystem::exists(entry.path() / "README.md")) << entry.path();
    if (std::filesystem::exists(entry.path() / "CMakeLists.txt")) continue;  // a program of its own
    ++count;
    EXPECT_FALSE(read_study(entry.path() / "study.toml").title.empty()) << entry.path();
  }
  EXPECT_GE(count, 6);
}

TEST(Study, DocumentationFileIsWhatTheTableSays) {
  EXPECT_EQ(read_file(std::filesystem::path(ISOPATCH_SOURCE_DIR) / "app/STUDY.md"), study_documentation())
      << "run: isopatch keys > app/STUDY.md";
  EXPECT_THAT(study_documentation("support"), HasSubstr("`displacement_gradient`"));
  EXPECT_ERROR(study_documentation("suport"), ErrorCode::invalid_argument, "no section or key");
}

}  // namespace
}  // namespace isopatch::app
