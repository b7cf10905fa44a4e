// What a study says of supports and loads: what is built of it, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

#include "app/problem/build_problem.hpp"
#include "app/study/parse_study.hpp"

namespace isopatch::app {
namespace {

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

TEST(HeldAndLoaded, PointsAreCornersOfPatches) {
  const std::string at = "[[support]]\ndisplacement = [0, 0, 0]\npoints = ";
  const BuiltProblem p = built(cube, at + "[[0, 0, 0], [1, 1, 0]]\n");
  EXPECT_EQ(p.problem.supports[0].corners.size(), 2u);
  ASSERT_FALSE(p.warnings.empty());
  EXPECT_THAT(p.warnings[0].text, HasSubstr("holds points: where that takes a force, stresses grow"));
  EXPECT_THAT(
      refusal(cube, at + "[[0.9, 0, 0]]\n"),
      HasSubstr(
          "no corner of a patch lies at (900, 0, 0) mm; the nearest is 100 mm away at (1000, 0, 0) mm"));
  EXPECT_THAT(refusal(cube, at + "[]\n"), HasSubstr("points is empty"));
  EXPECT_THAT(refusal(cube, at + "[[0, 0, 0]]\nfaces = [\"x_min\"]\n"), HasSubstr("write two supports"));
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
