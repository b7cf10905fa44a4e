#include "segmentation/sweeps/swept_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

/// Hexahedra that fill the solid and meet side to side; what lies on its faces has their areas, face by face.
void expect_sound(const Brep& solid, const CellComplex& complex) {
  double volume = 0;
  std::map<FaceId, double> areas;
  std::map<FaceId, int> uses;
  const std::vector<Brep> cells = geometry::cell_solids(solid, complex);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    EXPECT_GT(cells[c].volume(), 0);
    volume += cells[c].volume();
    ASSERT_EQ(cells[c].faces().size(), 6U);
    ASSERT_EQ(cells[c].edges().size(), 12U);
    ASSERT_EQ(cells[c].vertices().cols(), 8);
    for (std::size_t f = 0; f < 6; ++f) {
      const FaceId face = complex.cells[c].faces[f].face;
      ++uses[face];
      if (const auto origin = complex.face(face).origin)
        areas[*origin] += cells[c].area(FaceId(static_cast<int>(f)));
    }
  }
  EXPECT_NEAR(volume, solid.volume(), 1e-9 * solid.volume());
  for (const auto& [face, count] : uses) EXPECT_EQ(count, complex.face(face).origin ? 1 : 2);
  ASSERT_EQ(areas.size(), solid.faces().size());
  for (const auto& [face, area] : areas) EXPECT_NEAR(area, solid.area(face), 1e-9 * solid.area());
}

struct Sample {
  const char* name;
  int hexahedra;  ///< at most
};

class SweptCells : public testing::TestWithParam<Sample> {};

TEST_P(SweptCells, FillTheSolidAndMeetSideToSide) {
  const Brep solid = geometry::test::made_brep(GetParam().name);
  const auto swept = swept_cells(solid);
  ASSERT_TRUE(swept);
  EXPECT_LE(static_cast<int>(swept->complex.cells.size()), GetParam().hexahedra);
  expect_sound(solid, swept->complex);
}

INSTANTIATE_TEST_SUITE_P(Solids, SweptCells,
                         testing::Values(Sample{"block", 1}, Sample{"cylinder", 5}, Sample{"drilled", 4},
                                         Sample{"grooved", 7}, Sample{"notched", 7}, Sample{"pocketed", 14},
                                         Sample{"countersunk", 8}, Sample{"drafted_pocket", 14},
                                         Sample{"drafted_boss", 14}, Sample{"shaft", 29},
                                         Sample{"bored_boss", 12}, Sample{"wavy", 5}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SweptCells, AreNoneOfOtherSolids) {
  for (const char* name : {"sphere", "torus", "spring", "round_corner"})
    EXPECT_FALSE(swept_cells(geometry::test::made_brep(name))) << name;
}

TEST(SweptCells, KnowNarrowWallsFromTheirNeighbours) {
  // Chamfers of 1e-4 and 1e-6 of the block's edge.
  for (const double e : {1e-4, 1e-6}) {
    geometry::Polyhedron chamfered;
    chamfered.vertices.resize(3, 10);
    chamfered.vertices << 0, 1, 1, 1 - e, 0, 0, 1, 1, 1 - e, 0,  //
        0, 0, 1 - e, 1, 1, 0, 0, 1 - e, 1, 1,                    //
        0, 0, 0, 0, 0, 1, 1, 1, 1, 1;
    chamfered.faces = {{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}, {0, 1, 6, 5}, {1, 2, 7, 6},
                       {2, 3, 8, 7},    {3, 4, 9, 8},    {4, 0, 5, 9}};
    const Brep block = geometry::make_brep(chamfered);
    const auto swept = swept_cells(block);
    ASSERT_TRUE(swept);
    expect_sound(block, swept->complex);
  }
}

}  // namespace
}  // namespace isopatch::segmentation
