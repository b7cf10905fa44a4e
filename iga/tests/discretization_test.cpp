#include "iga/spaces/discretization.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"

namespace isopatch::iga {
namespace {

std::array<int, 3> elements(const geometry::NurbsVolume& patch) {
  return {patch.knots(0).element_count(), patch.knots(1).element_count(), patch.knots(2).element_count()};
}

TEST(Discretization, RefineHalvesWhatTheOtherOptionsMade) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {4, 1, 1}, .patches = {2, 1, 1}}));
  for (const int refine : {0, 1, 2}) {
    const int halved = 1 << refine;
    for (const auto& patch :
         discretize(model, {.refine = refine, .elements_per_direction = {16, 2, 1}}).patches)
      EXPECT_EQ(elements(patch), (std::array{16 * halved, 2 * halved, halved}));
    for (const auto& patch : discretize(model, {.refine = refine, .max_size = 0.5}).patches)
      EXPECT_EQ(elements(patch), (std::array{4 * halved, 2 * halved, 2 * halved}));
  }
}

// A row of three patches of which the middle one is finer.
DiscretizationOptions fine_middle(bool spread) {
  return {
      .degree = {2, 2, 2},
      .refine = 1,
      .patches = {{.patches = {1}, .degree = {3, 2, 2}, .elements_per_direction = {1, 1, 3}, .refine = 1}},
      .spread = spread};
}

std::array<int, 3> elements_of(const geometry::NurbsVolume& patch) {
  return {patch.knots(0).element_count(), patch.knots(1).element_count(), patch.knots(2).element_count()};
}

TEST(Discretization, OfSomePatchesContinuesThroughTheirNeighbours) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.patches = {3, 1, 1}}));
  const Discretization d = discretize(model, fine_middle(true));
  EXPECT_EQ(d.model.interfaces().size(), 2u);
  EXPECT_EQ(elements_of(d.patches[0]), (std::array{2, 4, 12}));
  EXPECT_EQ(elements_of(d.patches[1]), (std::array{4, 4, 12}));
  EXPECT_EQ(elements_of(d.patches[2]), (std::array{2, 4, 12}));
  EXPECT_EQ(d.patches[1].degree(0), 3);
  EXPECT_EQ(d.patches[0].degree(0), 2);
}

TEST(Discretization, OfSomePatchesEndsAtTheirFacesWhereItMay) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.patches = {3, 1, 1}, .orientation_seed = 3}));
  DiscretizationOptions options = fine_middle(false);
  const Discretization d = discretize(model, options);
  EXPECT_TRUE(d.model.interfaces().empty());
  ASSERT_EQ(d.model.non_matching().size(), 2u);
  EXPECT_EQ(d.model.non_matching()[0].first.patch, PatchId(0));
  EXPECT_EQ(d.model.boundary_faces(), model.boundary_faces());
  EXPECT_EQ(d.model.bodies().size(), 1u);
  EXPECT_EQ(elements_of(d.patches[0]), (std::array{2, 2, 2}));
  // What differs across the faces alone leaves them as they are.
  options.patches = {{.patches = {1}, .refine = 0}};
  EXPECT_EQ(discretize(model, options).model.interfaces().size(), 2u);
}

TEST(Discretization, OfPatchesThatAreNotThereIsRefused) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.patches = {3, 1, 1}}));
  EXPECT_ERROR(discretize(model, {.patches = {{.patches = {3}, .refine = 1}}}), ErrorCode::invalid_argument,
               "patch 3 is to be refined, of 3 patches");
}

}  // namespace
}  // namespace isopatch::iga
