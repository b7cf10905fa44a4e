#include "geometry/interface.hpp"

#include <gtest/gtest.h>

#include "geometry/splines/refine.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

std::vector<FaceOrientation> all_eight() {
  std::vector<FaceOrientation> result;
  for (const bool swapped : {false, true})
    for (const bool first : {false, true})
      for (const bool second : {false, true}) result.push_back({swapped, first, second});
  return result;
}

TEST(FaceOrientation, OneAfterTheOtherIsOneOrientation) {
  const Parameter<2> at(0.25, 0.125);  // every coordinate and 1 - coordinate differs; exact
  for (const FaceOrientation& first : all_eight()) {
    EXPECT_EQ(composed(first, inverse(first)), FaceOrientation());
    for (const FaceOrientation& second : all_eight())
      EXPECT_EQ(composed(first, second)(at), second(first(at)));
  }
}

TEST(FaceOrientation, IsKnownByTheCorners) {
  const std::array<int, 4> labels = {7, 3, 9, 4};
  for (const FaceOrientation& orientation : all_eight()) {
    std::array<int, 4> there{};
    for (int corner = 0; corner < 4; ++corner) {
      const Parameter<2> image = orientation(Parameter<2>(corner & 1, corner >> 1));
      there[static_cast<std::size_t>(image[0] + 2 * image[1])] = labels[static_cast<std::size_t>(corner)];
    }
    EXPECT_EQ(orientation_between(labels, there), orientation);
  }
  EXPECT_EQ(orientation_between(labels, {7, 3, 4, 9}), std::nullopt);
  EXPECT_EQ(orientation_between(labels, {7, 3, 9, 5}), std::nullopt);
}

TEST(StatedInterface, FollowsPatchesWhoseFirstDirectionIsTurnedAround) {
  const NurbsVolume box = test::box_between({0, 0, 0}, {1, 2, 3});
  const NurbsVolume turned = reversed(box, 0);
  const Parameter<2> at(0.3, 0.6);
  for (const Side side : all_sides)
    for (const bool first : {false, true})
      for (const bool second : {false, true}) {
        // A face and itself: the same points before and after.
        const StatedInterface stated =
            turned_around({{PatchId(0), side}, {PatchId(1), side}, {}}, first, second);
        const NurbsVolume &one = first ? turned : box, &other = second ? turned : box;
        const Eigen::Vector3d point = one.point(on_side(one, stated.first.side, at));
        const Eigen::Vector3d image = other.point(on_side(other, stated.second.side, stated.orientation(at)));
        EXPECT_LT((point - image).norm(), 1e-15) << name(side) << first << second;
        EXPECT_EQ(exchanged(exchanged(stated)), stated);
      }
}

}  // namespace
}  // namespace isopatch::geometry
