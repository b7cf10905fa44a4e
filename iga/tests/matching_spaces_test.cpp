#include "iga/spaces/matching_spaces.hpp"

#include <gtest/gtest.h>

#include "geometry/models/box.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::iga {
namespace {

// A row of patches, of which one has a further knot across the row.
geometry::MultiPatch row(int patches, std::size_t refined) {
  geometry::PatchSet set = geometry::box_model({.patches = {patches, 1, 1}});
  set.patches[refined] = geometry::insert_knots(set.patches[refined], 1, {0.3});
  return geometry::connect(std::move(set));
}

TEST(MatchingSpaces, KnotsTravelBothWaysThroughALongRow) {
  for (const std::size_t refined : {std::size_t{0}, std::size_t{17}, std::size_t{39}}) {
    const geometry::MultiPatch model = row(40, refined);
    DirectionKnots knots;
    for (const auto& patch : model.patches())
      for (int d = 0; d < 3; ++d) knots.push_back(patch.knots(d));
    knots = matched(model, std::move(knots));
    for (std::size_t i = 0; i < knots.size(); ++i)
      EXPECT_EQ(knots[i].element_count(), i % 3 == 1 ? 2 : 1) << "patch " << i / 3;
  }
}

}  // namespace
}  // namespace isopatch::iga
