#include "app/problem/loose_bodies.hpp"

#include <gmock/gmock.h>

#include "app/tests/program_fixture.hpp"
#include "geometry/models/box.hpp"

namespace isopatch::app {
namespace {

using geometry::NurbsVolume;
using testing::AllOf;

NurbsVolume box_from(const Eigen::Vector3d& low, const Eigen::Vector3d& size) {
  return geometry::box_model({.size = size, .origin = low}).patches[0];
}

std::vector<Warning> warnings_of(std::vector<NurbsVolume> patches) {
  return loose_body_warnings(geometry::connect({std::move(patches), {}, {}}));
}

TEST(LooseBodies, AGapIsSaidWithItsWidthAndPlace) {
  const auto warnings = warnings_of({box_from({0, 0, 0}, {1, 1, 1}), box_from({1.01, 0, 0}, {1, 1, 1})});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].text, AllOf(HasSubstr("body 0 (patch 0) and body 1 (patch 1) are 10 mm apart"),
                                      HasSubstr("model.same_point")));
  EXPECT_NEAR((*warnings[0].place)[0], 1, 0.011);
}

TEST(LooseBodies, TheNarrowestPlaceOfAGapIsFoundBetweenThePointsOfTheGrid) {
  // The corner of the turned block points at a place between the grid's points of the other's face.
  const NurbsVolume cube = box_from({0, 0, 0}, {1, 1, 1});
  const double s = std::sqrt(0.5);
  Eigen::Matrix3d turn;
  turn << s, -s, 0, s, s, 0, 0, 0, 1;
  const NurbsVolume turned(cube.knots(),
                           (turn * cube.control_points()).colwise() + Eigen::Vector3d(0.37, 1.013, 0.1));
  const auto warnings = warnings_of({cube, turned});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].text, HasSubstr("are 13 mm apart"));
}

TEST(LooseBodies, AnOverlapIsSaidWithItsDepth) {
  const auto warnings =
      warnings_of({box_from({0, 0, 0}, {1, 1, 1}), box_from({0.9, 0.3, 0.3}, {1, 0.4, 0.4})});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].text, HasSubstr("run into each other, 100 mm deep"));
}

TEST(LooseBodies, FarBodiesAndPatchesOfOneBodyAreNone) {
  EXPECT_TRUE(warnings_of({box_from({0, 0, 0}, {1, 1, 1}), box_from({1.5, 0, 0}, {1, 1, 1})}).empty());
  EXPECT_TRUE(loose_body_warnings(
                  geometry::connect(geometry::box_model(
                      {.patches = {2, 2, 2}, .distortion = 0.3, .curvature = 0.25, .orientation_seed = 5})))
                  .empty());
}

TEST(LooseBodies, PatchesOfABodyThatRunThroughEachOtherAreNamed) {
  // One block on another, and a third from the side of the upper one down into the lower one.
  std::vector<NurbsVolume> patches = {box_from({0, 0, 0}, {1, 1, 1}), box_from({0, 0, 1}, {1, 1, 1})};
  Eigen::Matrix3Xd points(3, 8);
  points << 1, 0.6, 1, 0.6, 1, 1.8, 1, 1.8,  //
      0, 0, 1, 1, 0, 0, 1, 1,                //
      1, 0.2, 1, 0.2, 2, 0.2, 2, 0.2;
  patches.emplace_back(NurbsVolume().knots(), points);
  const auto warnings = warnings_of(std::move(patches));
  ASSERT_FALSE(warnings.empty());
  EXPECT_THAT(warnings[0].text, AllOf(HasSubstr("patch 0 and patch 2 of body 0 run through each other")));
}

}  // namespace
}  // namespace isopatch::app
