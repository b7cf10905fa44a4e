#include "iga/spaces/discretization.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace isopatch::iga
