#include "segmentation/pieces/pieces_apart.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::segmentation {
namespace {

// Nothing that divides one piece goes on into another, so there are fewer hexahedra than where they meet.
TEST(PiecesApart, FillTheSolid) {
  const geometry::Brep solid = geometry::test::made_brep("angle");
  const auto apart = pieces_apart(solid);
  ASSERT_TRUE(apart);
  EXPECT_LE(apart->complex.cells.size(), pieced_cells(solid)->complex.cells.size());
  double volume = 0;
  for (const geometry::Brep& cell : geometry::cell_solids(solid, apart->complex)) {
    EXPECT_EQ(cell.faces().size(), 6U);
    volume += cell.volume();
  }
  EXPECT_NEAR(volume, solid.volume(), 1e-9 * solid.volume());
}

TEST(PiecesApart, AreCutWhereTheUserSays) {
  const geometry::Brep solid = geometry::test::made_brep("block");
  const Eigen::Vector3d middle = solid.vertices().rowwise().mean();
  const geometry::PlaneSurface plane{middle, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
  EXPECT_EQ(pieces_apart(solid, {plane})->complex.cells.size(), 2U);
  const geometry::PlaneSurface beside{middle + 10 * solid.size() * Eigen::Vector3d::UnitZ(), plane.x,
                                      plane.y};
  EXPECT_ERROR(pieces_apart(solid, {beside}), ErrorCode::invalid_argument, "cut 1 cuts nothing off");
}

}  // namespace
}  // namespace isopatch::segmentation
