#include "geometry/brep/flat_tips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::geometry {
namespace {

const double depth = 6e-3 / std::tan(59 * std::numbers::pi / 180);

TEST(FlatTips, AreOfDrills) {
  // A bore of radius 6 down into a block to z = 14, its tip below.
  const std::vector<DrillTip> tips = drill_tips(test::made_brep("tipped_bore"));
  ASSERT_EQ(tips.size(), 1U);
  EXPECT_NEAR((tips[0].apex - Eigen::Vector3d(0.03, 0.02, 0.014 - depth)).norm(), 0, 1e-12);
  EXPECT_NEAR(tips[0].axis.z(), 1, 1e-12);
  EXPECT_NEAR(tips[0].radius, 6e-3, 1e-12);
  EXPECT_NEAR(tips[0].depth, depth, 1e-12);
  // A point that stands out, a countersink, a flat bottom.
  for (const char* name : {"cone", "pointed_rod", "countersunk", "blind_bore"})
    EXPECT_TRUE(drill_tips(test::made_brep(name)).empty()) << name;
}

TEST(FlatTips, FillTheApex) {
  const Brep solid = test::made_brep("tipped_bore");
  const Brep flat = with_flat_tips(solid, drill_tips(solid), 0.25);
  EXPECT_EQ(flat.faces().size(), solid.faces().size() + 1);
  const double filled = std::numbers::pi / 3 * std::pow(0.25 * 6e-3, 2) * 0.25 * depth;
  EXPECT_NEAR(flat.volume() - solid.volume(), filled, 1e-9 * solid.volume());
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f)
    EXPECT_EQ(flat.face(FaceId(f)).kind, solid.face(FaceId(f)).kind);
  const FaceId last(static_cast<int>(solid.faces().size()));
  EXPECT_EQ(flat.face(last).kind, SurfaceKind::plane);
  EXPECT_NEAR(flat.area(last), std::numbers::pi * std::pow(0.25 * 6e-3, 2), 1e-15);
}

TEST(FlatTips, HaveAShareOfTheBore) {
  const Brep solid = test::made_brep("tipped_bore");
  for (const double share : {0.0, 1.0, std::nan("")})
    EXPECT_ERROR(with_flat_tips(solid, drill_tips(solid), share), ErrorCode::invalid_argument,
                 "between 0 and 1");
}

}  // namespace
}  // namespace isopatch::geometry
