#include "app/problem/selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/sphere.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;
using testing::HasSubstr;

MultiPatch two_boxes() {
  return geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
}

std::vector<std::string> labels(const MultiPatch& model, const FaceSelection& selection) {
  std::vector<std::string> result;
  for (const auto& face : select_faces(model, selection).faces) result.push_back(model.label(face));
  return result;
}

std::string refusal(const MultiPatch& model, FaceSelection selection) {
  selection.place = {"study.toml", 7, 1};
  try {
    select_faces(model, selection);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Selection, FindsFacesByNameOfFaceOrBoundary) {
  const MultiPatch model = two_boxes();
  EXPECT_THAT(labels(model, {.faces = {"0:west"}}), testing::ElementsAre("0:west"));
  EXPECT_THAT(labels(model, {.faces = {"z_max", "1:back"}}),
              testing::UnorderedElementsAre("0:back", "1:back"));
}

TEST(Selection, FindsFacesByGeometry) {
  const MultiPatch box = two_boxes();
  EXPECT_THAT(labels(box, {.where = FaceConditions{.plane = PlaneCondition{{2, 0, 0}, {1, 0, 0}}}}),
              testing::ElementsAre("1:east"));
  EXPECT_THAT(labels(box, {.where = FaceConditions{.normal = Eigen::Vector3d(0, 0, -1)}}),
              testing::SizeIs(2));
  EXPECT_THAT(labels(box, {.where = FaceConditions{.box = BoxCondition{{0, 0, 0}, {1, 1, 1}}}}),
              testing::SizeIs(5));
  // Names and geometry together: only what fulfils both.
  EXPECT_THAT(
      labels(box, {.faces = {"z_max"}, .where = FaceConditions{.box = BoxCondition{{0, 0, 0}, {1, 1, 1}}}}),
      testing::ElementsAre("0:back"));
  const MultiPatch ring = geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(360)}));
  EXPECT_EQ(select_faces(ring, {.where = FaceConditions{.cylinder = CylinderCondition{.radius = 1}}}).faces,
            select_faces(ring, {.faces = {"inner"}}).faces);
  const MultiPatch octant = geometry::connect(geometry::sphere_model({}));
  EXPECT_EQ(select_faces(octant, {.where = FaceConditions{.sphere = SphereCondition{.radius = 2}}}).faces,
            select_faces(octant, {.faces = {"outer"}}).faces);
}

TEST(Selection, FindsLeftHandedPatchesByTheInputsNames) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const MultiPatch model =
        geometry::connect(geometry::box_model({.patches = {2, 2, 1}, .orientation_seed = seed}));
    for (const auto& face : model.boundary_faces())
      EXPECT_THAT(select_faces(model, {.faces = {model.label(face)}}).faces, testing::ElementsAre(face));
  }
}

TEST(Selection, RefusesFacesThatDoNotExist) {
  const MultiPatch model = two_boxes();
  EXPECT_THAT(refusal(model, {.faces = {"5:west"}}),
              HasSubstr("study.toml:7:1: face \"5:west\" does not exist: the model has patches 0 to 1"));
  EXPECT_THAT(refusal(model, {.faces = {"0:wes"}}), HasSubstr("(did you mean 'west'?)"));
  EXPECT_THAT(refusal(model, {.faces = {"0:east"}}),
              HasSubstr("face 0:east is no boundary: it is joined to 1:west"));
  EXPECT_THAT(refusal(model, {.faces = {"x_mim"}}),
              HasSubstr("no boundary is named \"x_mim\" (did you mean 'x_min'?); boundaries: x_min, y_min"));
}

TEST(Selection, MatchingNothingNamesWhatCameNearest) {
  const std::string message =
      refusal(two_boxes(), {.where = FaceConditions{.plane = PlaneCondition{{2.01, 0, 0}, {1, 0, 0}}}});
  EXPECT_THAT(message,
              HasSubstr("study.toml:7:1: the selection matches no face. Nearest: 1:east (up to 10 mm away"));
  EXPECT_THAT(message, HasSubstr("boundaries: x_min"));
  EXPECT_THAT(
      refusal(two_boxes(), {.where = FaceConditions{.normal = Eigen::Vector3d(1, 1, 0).normalized()}}),
      HasSubstr("normal 45.0 deg off"));
}

TEST(Selection, NamesTheFacesThatMissTheToleranceByLittle) {
  const MultiPatch model = geometry::connect(geometry::box_model({.patches = {1, 2, 1}}));
  // A tilted plane: 0.3 mm from the first patch's side at most, 0.7 mm from the second's.
  const auto side = [](double tolerance) {
    const PlaneCondition plane{{3e-4, 0, 0}, Eigen::Vector3d(1, 1e-3, 0).normalized()};
    return FaceSelection{.where = FaceConditions{.plane = plane, .tolerance = tolerance},
                         .place = {"study.toml", 7, 1}};
  };
  const auto warning = [&](double tolerance) {
    const SelectedFaces selected = select_faces(model, side(tolerance));
    return near_miss_warning(model, side(tolerance), "support 1 (side)", selected);
  };
  EXPECT_THAT(select_faces(model, side(3.1e-4)).faces, testing::SizeIs(1));
  EXPECT_EQ(
      warning(3.1e-4),
      "study.toml:7:1: support 1 (side) leaves out 1:west (up to 700 um away); its tolerance is 310 um. "
      "tolerance = \"700 um\" would include them");
  EXPECT_THAT(select_faces(model, side(7.1e-4)).faces, testing::SizeIs(2));
  EXPECT_EQ(warning(7.1e-4), "");
  // Both are more than five tolerances away from a plane of another direction, or point another way.
  FaceSelection turned = side(3.1e-4);
  turned.where->plane = PlaneCondition{{0, 0, 1e-3}, {0, 0, 1}};
  turned.where->tolerance = 1.1e-3;
  turned.where->normal = Eigen::Vector3d(0, 0, -1);
  EXPECT_THAT(select_faces(model, turned).near_misses, testing::IsEmpty());
}

TEST(Selection, PatchesAreRangesNamesOrAll) {
  geometry::PatchSet set = geometry::box_model({.patches = {6, 1, 1}});
  set.names = {"foot", "leg", "leg", "leg", "seat"};
  const geometry::MultiPatch model = geometry::connect(std::move(set));
  EXPECT_EQ(select_patches(model, {}).size(), 6u);
  EXPECT_THAT(select_patches(model, {.ranges = {{4, 5}, {0, 0}, {4, 4}}}),
              testing::ElementsAre(PatchId(0), PatchId(4), PatchId(5)));
  EXPECT_THAT(select_patches(model, {.ranges = {{5, 5}}, .names = {"leg"}}),
              testing::ElementsAre(PatchId(1), PatchId(2), PatchId(3), PatchId(5)));
  EXPECT_ERROR(select_patches(model, {.ranges = {{5, 6}}}), ErrorCode::invalid_argument,
               "patch 6 does not exist");
  try {
    select_patches(model, {.names = {"lag"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no patch is called \"lag\" (did you mean 'leg'?)"));
  }
}

}  // namespace
}  // namespace isopatch::app
