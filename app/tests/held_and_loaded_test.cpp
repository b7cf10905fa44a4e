// What a study says of supports and loads: what is built of it, and what is refused.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

#include "app/problem/build_problem.hpp"
#include "app/study/parse_study.hpp"

namespace isopatch::app {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string cube = "generate = \"box\"\n";
const std::string two_eyes = "generate = \"link\"\n";

BuiltProblem built(const std::string& model, const std::string& more, const std::string& material = "") {
  return build_problem(parse_study(
      "[model]\n" + model + "[[material]]\nyoung = 1e9\npoisson = 0.3\n" + material + more, "study.toml"));
}

std::string refusal(const std::string& model, const std::string& more) {
  try {
    built(model, more);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

const std::string clamp = "[[support]]\nfaces = [\"x_min\"]\ndisplacement = [0, 0, 0]\n";

TEST(HeldAndLoaded, ACylindricalSupportFindsItsAxis) {
  const BuiltProblem p =
      built(two_eyes, "[[support]]\nfaces = [\"bore_right\"]\ncylindrical = { axial = \"fixed\" }\n");
  const auto& about = std::get<iga::CylindricalSupport>(p.problem.supports[0].condition);
  EXPECT_LT((about.point - Eigen::Vector3d(100, 0, 6)).norm(), 1e-9);
  EXPECT_EQ(about.axis, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(about.radial && !about.tangential && about.axial);
  EXPECT_THAT(refusal(two_eyes, "[[support]]\nfaces = [\"bore_left\", \"bore_right\"]\ncylindrical = {}\n"),
              HasSubstr("study.toml:6:1: cylindrical: the faces are no cylinders about one axis"));
  EXPECT_THAT(refusal(two_eyes, "[[support]]\nfaces = [\"top\"]\ncylindrical = {}\n"),
              HasSubstr("no cylinders about one axis"));
}

TEST(HeldAndLoaded, ATotalStiffnessIsSpreadOverTheArea) {
  const BuiltProblem p =
      built(cube + "size = [1, 2, 3]\n",
            "[[support]]\nfaces = [\"x_min\"]\nelastic = { normal = 1, total_normal = 12 }\n");
  EXPECT_NEAR(std::get<iga::ElasticSupport>(p.problem.supports[0].condition).normal, 3, 1e-12);
}

TEST(HeldAndLoaded, PointsAreCornersOfPatchesOrSprung) {
  const std::string at = "[[support]]\ndisplacement = [0, 0, 0]\npoints = ";
  const BuiltProblem p = built(cube, at + "[[0, 0, 0], [1, 1, 0]]\n");
  EXPECT_EQ(p.problem.supports[0].corners.size(), 2u);
  ASSERT_FALSE(p.warnings.empty());
  EXPECT_THAT(p.warnings[0].text, HasSubstr("holds points: where that takes a force, stresses grow"));
  const BuiltProblem inside = built(cube, at + "[[0.9, 0, 0], [0, 0, 0], [0.2, 0.3, 0.4]]\n");
  EXPECT_EQ(inside.problem.supports[0].corners.size(), 1u);
  ASSERT_EQ(inside.problem.supports[0].points.size(), 2u);
  EXPECT_LT((inside.problem.supports[0].points[1].parameter - Eigen::Vector3d(0.2, 0.3, 0.4)).norm(), 1e-9);
  EXPECT_THAT(refusal(cube, at + "[[1.1, 0, 0]]\n"), HasSubstr("lies 100 mm outside the part"));
  EXPECT_THAT(refusal(cube, "[[support]]\ndisplacement = [0.1, 0, 0]\npoints = [[0.5, 0, 0]]\n"),
              HasSubstr("study.toml:6:1: support 1 moves points or a line"));
  EXPECT_THAT(refusal(cube, at + "[]\n"), HasSubstr("points is empty"));
  EXPECT_THAT(refusal(cube, at + "[[0, 0, 0]]\nfaces = [\"x_min\"]\n"), HasSubstr("write two supports"));
}

TEST(HeldAndLoaded, LinesAreHeldAndLoaded) {
  const BuiltProblem p =
      built(cube,
            "[[support]]\ndisplacement = [0, 0, 0]\nline = [[0, 0.5, 0], [1, 0.5, 0]]\n"
            "[[load]]\nforce = [0, 0, 2]\nline = [[0.2, 0.3, 1], [0.8, 0.3, 1], [0.8, 0.9, 1]]\n"
            "[[load]]\nforce = [0, 0, 3]\npoints = [[0.5, 0.5, 0.5], [0.5, 0.5, 1]]\n");
  const auto weight = [](const std::vector<iga::PatchPoint>& points) {
    double sum = 0;
    for (const iga::PatchPoint& point : points) sum += point.weight;
    return sum;
  };
  EXPECT_NEAR(weight(p.problem.supports[0].points), 1, 1e-12);
  ASSERT_EQ(p.problem.point_loads.size(), 2u);
  EXPECT_NEAR(weight(p.problem.point_loads[0].points), 1, 1e-12);
  EXPECT_EQ(p.problem.point_loads[1].points.size(), 2u);
  EXPECT_EQ(p.loads[1].total, Eigen::Vector3d(0, 0, 3));
  EXPECT_THAT(region_text(p.loads[0]), HasSubstr("along a line of 1200 mm"));
  EXPECT_THAT(p.warnings.front().text, HasSubstr("holds a line: where that takes a force, stresses grow"));
  EXPECT_THAT(refusal(cube, clamp + "[[load]]\nforce = [0, 0, 1]\nline = [[0, 0, 1]]\n"),
              HasSubstr("a line needs two points"));
  EXPECT_THAT(refusal(cube, clamp + "[[load]]\npressure = 1\nline = [[0, 0, 1]]\n"),
              HasSubstr("points and lines take a force, not pressure"));
  EXPECT_THAT(refusal(cube, clamp + "[[load]]\nforce = [0, 0, 1]\nline = [[0, 0, 1], [0, 0, 2]]\n"),
              HasSubstr("outside the part"));
  EXPECT_THAT(
      refusal(cube, clamp + "[[load]]\nforce = [0, 0, 1]\nfaces = [\"x_max\"]\npoints = [[0, 0, 1]]\n"),
      HasSubstr("more than one of faces, points and a line"));
}

TEST(HeldAndLoaded, PartsOfFacesAreHeldAndLoaded) {
  const std::string disc = "part = { cylinder = { point = [0.5, 0.5, 0], axis = \"z\", radius = 0.3 } }\n";
  const BuiltProblem p =
      built(cube, "[[support]]\nfaces = [\"z_min\"]\nsymmetry = true\n" + disc +
                      "[[support]]\nfaces = [\"z_min\"]\nelastic = { total_normal = 2 }\n" + disc +
                      "[[load]]\nfaces = [\"z_max\"]\npressure = 2\n" + disc +
                      "[[load]]\nforce = [1, 2, 3]\npart = { box = { min = [0.9, 0, 0], max = "
                      "[2, 1, 0.5] } }\n");
  const double area = 3.14159265358979 * 0.09;
  EXPECT_NEAR(p.supports[0].area, area, 1e-9);
  EXPECT_NEAR(std::get<iga::ElasticSupport>(p.problem.supports[1].condition).normal, 2 / area, 1e-6);
  EXPECT_NEAR(p.loads[0].total[2], -2 * area, 1e-9);
  EXPECT_THAT(region_text(p.loads[0]), HasSubstr("on part of z_max (1 face), 2827 cm^2"));
  // What of all faces lies in the box: half of the end, and strips of three sides.
  EXPECT_NEAR(p.loads[1].area, 0.5 + 0.1 + 0.05 + 0.05, 1e-12);
  EXPECT_THAT(
      refusal(cube, clamp + "[[load]]\nfaces = [\"x_max\"]\npressure = 1\npart = { plane = { point = [0, 0, "
                            "2], normal = \"z\" } }\n"),
      HasSubstr("none of the faces has an area in there; 0:east comes nearest"));
  EXPECT_THAT(refusal(cube, clamp + "[[load]]\nfaces = [\"x_max\"]\npressure = 1\npart = {}\n"),
              HasSubstr("part is empty"));
}

// A strip along an edge, 0.4 of an element wide: one row of functions of degree 2, whose integral is a third.
TEST(HeldAndLoaded, APartNarrowerThanAnElementIsHeldWithAWarning) {
  const std::string fine = cube + "[discretization]\ndegree = 2\nelements_per_direction = 4\n";
  const auto strip = [](const char* width) {
    return fmt::format(
        "[[support]]\nname = \"strip\"\nfaces = [\"z_min\"]\ndisplacement = [0, 0, 0]\n"
        "part = {{ box = {{ min = [-1, -1, -1], max = [{}, 2, 2] }} }}\n",
        width);
  };
  const BuiltProblem narrow = built(fine, strip("0.1"));
  ASSERT_FALSE(narrow.warnings.empty());
  EXPECT_THAT(narrow.warnings.front().text, AllOf(HasSubstr("strip"), HasSubstr("narrower than the elements"),
                                                  HasSubstr("worth 833.3 cm^2 instead of 1000 cm^2")));
  for (const Warning& warning : built(fine, strip("0.6")).warnings)
    EXPECT_THAT(warning.text, testing::Not(HasSubstr("narrower")));
}

TEST(HeldAndLoaded, SupportsThatHoldNothingOrTooMuchAreRefused) {
  const std::string faces = "[[support]]\nfaces = [\"x_min\"]\n";
  EXPECT_THAT(refusal(cube, faces + "elastic = {}\n"), HasSubstr("needs a stiffness above 0"));
  EXPECT_THAT(refusal(cube, faces + "elastic = { normal = \"5 MPa\" }\n"), HasSubstr("N/m^3"));
  EXPECT_THAT(refusal(cube, faces + "cylindrical = { radial = \"free\" }\n"), HasSubstr("holds nothing"));
  EXPECT_THAT(refusal(cube, faces + "cylindrical = { axis = \"x\" }\n"), HasSubstr("both point and axis"));
  EXPECT_THAT(refusal(cube, faces + "free_body = true\n"), HasSubstr("leave out faces"));
  EXPECT_THAT(refusal(cube, faces + "elastic = { normal = 1 }\ncylindrical = {}\n"),
              HasSubstr("write two supports"));
}

TEST(HeldAndLoaded, LoadsAreRefusedWithTheirPlace) {
  const std::string on = clamp + "[[load]]\nfaces = [\"x_max\"]\n";
  EXPECT_THAT(refusal(cube, on + "bearing = [1, 0, 0]\n"),
              HasSubstr("study.toml:9:1: 'load 1': no pressure"));
  EXPECT_THAT(refusal(cube, on + "remote = {}\n"), HasSubstr("force or a moment that is not 0"));
  EXPECT_THAT(refusal(cube, on + "hydrostatic = { density = 1000, surface = [0, 0, 0] }\n"),
              HasSubstr("wets none"));
  EXPECT_THAT(refusal(cube, clamp + "[[load]]\nrotation = { speed = \"3000 rpm\" }\n"),
              HasSubstr("study.toml:9:1: 'load 1': patch 0 has no density"));
  EXPECT_THAT(refusal(cube, clamp + "[[load]]\ntemperature = { change = 50 }\n"),
              HasSubstr("patch 0 has no thermal expansion"));
}

TEST(HeldAndLoaded, AccelerationIsGravityTheOtherWay) {
  const BuiltProblem p =
      built(cube, clamp + "[[load]]\nacceleration = [0, 2, 0]\n[[load]]\nrotation = { speed = 3 }\n",
            "density = 10\n");
  EXPECT_LT((p.loads[0].total - Eigen::Vector3d(0, -20, 0)).norm(), 1e-12);
  EXPECT_LT((p.loads[1].total - Eigen::Vector3d(45, 45, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace isopatch::app
