#include "segmentation/sweeps/layered_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/sweeps/swept_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

class LayeredCells : public testing::TestWithParam<const char*> {};

// Drafted walls go through both layers of the last two: what one layer has of them the other continues.
TEST_P(LayeredCells, FillTheSolidWithFewerHexahedra) {
  const Brep solid = geometry::test::made_brep(GetParam());
  const auto layered = layered_cells(solid);
  ASSERT_TRUE(layered);
  EXPECT_LT(layered->complex.cells.size(), swept_cells(solid)->complex.cells.size());
  double volume = 0;
  for (const Brep& cell : geometry::cell_solids(solid, layered->complex)) {
    EXPECT_EQ(cell.faces().size(), 6U);
    EXPECT_EQ(cell.edges().size(), 12U);
    EXPECT_GT(cell.volume(), 0);
    volume += cell.volume();
  }
  EXPECT_NEAR(volume, solid.volume(), 1e-9 * solid.volume());
}

INSTANTIATE_TEST_SUITE_P(Solids, LayeredCells, testing::Values("pocketed", "drafted_pocket", "drafted_boss"),
                         [](const auto& info) { return std::string(info.param); });

// The plate's top is in part below the boss, in part outside: it has the name of what is outside.
TEST(LayeredCells, SidesInPartOnAFloorBelongToIt) {
  const Brep solid = geometry::test::made_brep("drafted_boss");
  const auto layered = layered_cells(solid);
  ASSERT_TRUE(layered);
  std::map<FaceId, int> sides;
  for (const geometry::CellFace& face : layered->complex.faces)
    if (face.origin) ++sides[*face.origin];
  EXPECT_EQ(sides.size(), solid.faces().size());
}

TEST(LayeredCells, AreNoneOfSolidsWithOneLayer) {
  for (const char* name : {"block", "drilled", "sphere"})
    EXPECT_FALSE(layered_cells(geometry::test::made_brep(name))) << name;
}

}  // namespace
}  // namespace isopatch::segmentation
