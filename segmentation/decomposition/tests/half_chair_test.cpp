#include "segmentation/decomposition/tests/half_chair.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "segmentation/decomposition/combinatorics/decomposition_search.hpp"
#include "segmentation/decomposition/decompose.hpp"
#include "segmentation/decomposition/search_cell.hpp"

namespace isopatch::segmentation {
namespace {

SearchCell half_chair_cell() {
  const geometry::Brep solid = geometry::make_brep(samples::half_chair());
  CellStore store(solid, {}, 1e9);
  return store.add(geometry::one_cell(solid), geometry::CellId(0));
}

CutTree half_chair_cuts(bool extensions) {
  SearchOptions options;
  options.extensions = extensions;
  return search_cuts(half_chair_cell(), combinatorial_oracle(), options);
}

TEST(HalfChair, IsASolidOfFourBlocks) {
  const geometry::Brep solid = geometry::make_brep(samples::half_chair());
  EXPECT_NEAR(solid.volume(), 32, 1e-12);
  const SearchCell cell = half_chair_cell();
  EXPECT_EQ(cell.graph.vertex_count, 24);
  EXPECT_EQ(non_convex_count(cell.graph), 5);
}

// The seat's lower side, extended through the legs, and its upper one cut it in three places; a loop that
// extends no face must leave the legs' concave corners along edges and diagonals, which makes prisms and
// tetrahedra.
TEST(HalfChair, NeedsFarFewerHexahedraWhereLoopsExtendFaces) {
  const CutTree extended = half_chair_cuts(true), plain = half_chair_cuts(false);
  ASSERT_TRUE(extended.complete());
  ASSERT_TRUE(plain.complete());
  EXPECT_EQ(extended.hexahedra, 4);
  EXPECT_GT(plain.hexahedra, 5 * extended.hexahedra);  // 25 with the options' defaults
}

TEST(HalfChair, IsCutIntoItsBlocksInSpace) {
  const Decomposition result =
      decompose(geometry::make_brep(samples::half_chair()), "half chair", {.method = Method::cuts});
  EXPECT_EQ(result.report.cells, 4);
  EXPECT_EQ(result.report.cuts, 3);
}

}  // namespace
}  // namespace isopatch::segmentation
