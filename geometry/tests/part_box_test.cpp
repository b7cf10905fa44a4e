#include "geometry/part_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/measures.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

TEST(PartBox, EndsAtTheArcAndNotAtItsControlPoints) {
  // From -45 to 45 degrees: the arc comes to x = 2 between its ends, its control points to x = 2.83.
  const double end = std::numbers::pi / 4;
  const MultiPatch sector = connect({{test::ring_sector(1, 2, -end, end, 0.5)}, {}, {}});
  const Eigen::AlignedBox3d box = part_box(sector);
  EXPECT_NEAR(box.max()[0], 2, 1e-12);
  EXPECT_NEAR(box.min()[0], std::cos(end), 1e-12);
  EXPECT_NEAR(box.max()[1], 2 * std::sin(end), 1e-12);
  EXPECT_NEAR(box.min()[1], -2 * std::sin(end), 1e-12);
  EXPECT_NEAR(box.max()[2] - box.min()[2], 0.5, 1e-12);
}

TEST(PartBox, FindsExtremesBetweenThePointsOfTheGrid) {
  for (const double turn : {0.1, 0.3, 0.55, 0.7}) {
    const MultiPatch sector = connect({{test::ring_sector(1, 2, -turn, 1.5 - turn, 1)}, {}, {}});
    EXPECT_NEAR(part_box(sector).max()[0], 2, 1e-12) << turn;
  }
}

TEST(PartBox, OfBoxesIsTheirs) {
  const Eigen::AlignedBox3d box = part_box(connect({test::eight_boxes(), {}, {}}));
  EXPECT_EQ(box.min(), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(box.max(), Eigen::Vector3d(3, 2.5, 2));
}

}  // namespace
}  // namespace isopatch::geometry
