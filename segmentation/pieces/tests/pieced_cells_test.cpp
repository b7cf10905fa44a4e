#include "segmentation/pieces/pieced_cells.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::segmentation {
namespace {

TEST(PiecedCells, AreNoneOfASphere) {
  EXPECT_FALSE(pieced_cells(geometry::test::made_brep("sphere")));
}

}  // namespace
}  // namespace isopatch::segmentation
