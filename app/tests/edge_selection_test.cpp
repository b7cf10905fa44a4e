#include "app/problem/edge_selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/problem/build_problem.hpp"
#include "app/study/parse_study.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

std::vector<std::string> labels(const MultiPatch& model, const FaceSelection& faces,
                                const FaceConditions& conditions) {
  std::vector<std::string> result;
  for (const iga::SupportedEdge& edge : select_edges(model, select_faces(model, faces).faces, conditions, {}))
    result.push_back(label(model, edge));
  return result;
}

TEST(EdgeSelection, FindsEdgesOfTheFacesOnly) {
  const MultiPatch box = geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  const FaceConditions floor{.plane = PlaneCondition{{0, 0, 0}, {0, 0, 1}}};
  EXPECT_THAT(labels(box, {.faces = {"x_max"}}, floor), ElementsAre("1:east+front"));
  EXPECT_THAT(labels(box, {.faces = {"y_min"}}, floor),
              UnorderedElementsAre("0:south+front", "1:south+front"));
  // The line where the patches meet is an edge of both.
  EXPECT_THAT(labels(box, {.faces = {"z_max"}}, {.plane = PlaneCondition{{1, 0, 0}, {1, 0, 0}}}),
              UnorderedElementsAre("0:east+back", "1:west+back"));
}

TEST(EdgeSelection, SeesTheWholeCurvedEdge) {
  const MultiPatch ring = geometry::connect(geometry::cylinder_model({}));
  EXPECT_THAT(labels(ring, {.faces = {"bottom"}}, {.cylinder = CylinderCondition{.radius = 1}}),
              ElementsAre("0:west+front"));
  // Both ends of the outer arc lie in the plane x + y = 2, the arc does not.
  const FaceConditions chord{.plane = PlaneCondition{{2, 0, 0}, Eigen::Vector3d(1, 1, 0).normalized()}};
  try {
    labels(ring, {.faces = {"bottom"}}, chord);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no edge of the support's faces lies there"));
    EXPECT_THAT(error.what(), HasSubstr("Nearest: 0:east+front (up to 585.8 mm away)"));
  }
}

TEST(EdgeSelection, NamesTheInputsSidesInPatchesThatWereTurnedAround) {
  geometry::PatchSet set = geometry::box_model({});
  // Left-handed: x runs backwards.
  Eigen::Matrix3Xd points = set.patches[0].control_points();
  points.row(0) = 1 - points.row(0).array();
  set.patches[0] = geometry::NurbsVolume(set.patches[0].knots(), points);
  set.boundaries.clear();
  const MultiPatch box = geometry::connect(set);
  ASSERT_TRUE(box.was_reversed(PatchId(0)));
  // The input's west is at x = 1.
  EXPECT_THAT(labels(box, {.faces = {"0:front"}}, {.plane = PlaneCondition{{1, 0, 0}, {1, 0, 0}}}),
              ElementsAre("0:west+front"));
}

constexpr const char* held_on_lines = R"([model]
generate = "box"
[[material]]
name = "steel"
[[support]]
name = "line"
faces = ["x_min"]
edges = { plane = { normal = "z" } }
displacement = [0, 0, "free"]
)";

TEST(EdgeSelection, MakesASupportThatHoldsNoFace) {
  const BuiltProblem built = build_problem(parse_study(held_on_lines, "study.toml"));
  ASSERT_EQ(built.problem.supports.size(), 1u);
  EXPECT_TRUE(built.problem.supports[0].faces.empty());
  EXPECT_EQ(built.problem.supports[0].edges.size(), 1u);
  EXPECT_EQ(region_text(built.supports[0]), "support 1 (line): displacement on 1 edge of patches");
  EXPECT_THAT(built.supports[0].edges, ElementsAre("0:west+front"));
}

TEST(EdgeSelection, IsRefusedForPlanesAndWithoutAPlace) {
  const auto refusal = [](std::string text, const std::string& old, const std::string& now) -> std::string {
    text.replace(text.find(old), old.size(), now);
    try {
      build_problem(parse_study(text, "study.toml"));
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(held_on_lines, "displacement = [0, 0, \"free\"]", "symmetry = true"),
              HasSubstr("needs whole faces"));
  EXPECT_THAT(refusal(held_on_lines, "normal = \"z\"", "point = [0, 0, 0.5], normal = \"z\""),
              HasSubstr("study.toml:5:"));
  EXPECT_THAT(refusal(held_on_lines, "plane = { normal = \"z\" }", "normal = \"z\""),
              HasSubstr("unknown key 'normal' in edges"));
}

}  // namespace
}  // namespace isopatch::app
