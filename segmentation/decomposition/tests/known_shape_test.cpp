#include "segmentation/decomposition/known_shape.hpp"

#include <gtest/gtest.h>

#include <string>

#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/looks.hpp"

namespace isopatch::segmentation {
namespace {

std::string seen_as(const std::string& name, const DecompositionOptions& options = {}) {
  const KnownShape known = known_shape(geometry::test::made_brep(name), options);
  return known.decomposition ? known.decomposition->report.seen_as : "";
}

TEST(KnownShape, IsTheWayWithFewerHexahedra) {
  EXPECT_EQ(seen_as("drilled"), "swept along z: 4 quadrilaterals between 2 levels");
  // Both ways take 5.
  EXPECT_EQ(seen_as("cylinder"), "swept along z: 5 quadrilaterals between 2 levels");
  // Swept it takes 29.
  EXPECT_EQ(seen_as("shaft"), "turned about z: 4 quadrilaterals in 4 sectors, 3 along the axis");
  EXPECT_EQ(seen_as("bent_tube"), "turned about (0, 0.6, 0.8): 4 quadrilaterals in 1 sector");
  EXPECT_EQ(seen_as("ellipsoid"), "one closed face around a hexahedron");
  EXPECT_EQ(seen_as("spring"), "");
  EXPECT_EQ(seen_as("sphere", {.method = Method::cuts}), "");
}

TEST(KnownShape, SaysWhyATurnedSolidIsNotDivided) {
  const KnownShape known = known_shape(geometry::test::made_brep("pointed_rod"), {});
  EXPECT_FALSE(known.decomposition);
  EXPECT_NE(known.why_not.find("comes to a point on the axis"), std::string::npos);
}

TEST(KnownShape, SaysWhyOneClosedFaceIsNotDivided) {
  const KnownShape known = known_shape(geometry::test::made_brep("banana"), {});
  EXPECT_FALSE(known.decomposition);
  EXPECT_EQ(known.why_not.find(
                "One face all around would do, but its face has an edge or a tip, or cannot be seen"),
            0U);
}

TEST(Looks, NameWhatASolidIsTakenForWithoutDividingIt) {
  const auto seen = [](const char* name) { return looks(geometry::test::made_brep(name)); };
  EXPECT_EQ(seen("drilled"), "swept along z");
  EXPECT_EQ(seen("shaft"), "swept along z");
  EXPECT_EQ(seen("sphere"), "turned about z");
  EXPECT_EQ(seen("bossed_bar"), "turned about x with branches");
  EXPECT_EQ(seen("filleted_boss"), "swept along z but for 1 round");
  EXPECT_EQ(seen("port"), "swept along x with bores, slots or bosses across");
  EXPECT_EQ(seen("spring"), "");
  // No division of it is known, and none is looked for.
  EXPECT_NE(seen("rounded_boss_on_fillet").find(" but for "), std::string::npos);
}

}  // namespace
}  // namespace isopatch::segmentation
