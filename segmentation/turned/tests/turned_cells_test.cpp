#include "segmentation/turned/turned_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "geometry/brep/cell_solids.hpp"
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

class TurnedCellsOf : public testing::TestWithParam<Sample> {};

TEST_P(TurnedCellsOf, FillTheSolidAndMeetSideToSide) {
  const Brep solid = geometry::test::made_brep(GetParam().name);
  const auto turned = turned_cells(solid);
  ASSERT_TRUE(turned);
  EXPECT_LE(static_cast<int>(turned->complex.cells.size()), GetParam().hexahedra);
  expect_sound(solid, turned->complex);
}

INSTANTIATE_TEST_SUITE_P(Solids, TurnedCellsOf,
                         testing::Values(Sample{"sphere", 7}, Sample{"torus", 20}, Sample{"cylinder", 5},
                                         Sample{"cone", 5}, Sample{"shaft", 29}, Sample{"ring_quarter", 1},
                                         Sample{"ring_150", 2}, Sample{"cone_quarter", 1},
                                         Sample{"shell_piece", 1}, Sample{"elbow_piece", 1},
                                         Sample{"ball_on_rod", 25}, Sample{"bored_ball", 4},
                                         Sample{"hollow_ball", 20}, Sample{"domed_rod", 15},
                                         Sample{"round_cup", 30}, Sample{"flat_cup", 30},
                                         Sample{"ring_in_halves", 12}, Sample{"sheave", 60},
                                         Sample{"round_ring", 44}, Sample{"bent_rod", 10},
                                         Sample{"bent_tube", 4}, Sample{"half_torus", 10},
                                         Sample{"half_shaft", 18}, Sample{"quarter_shaft", 3},
                                         Sample{"three_quarters", 12}, Sample{"half_dome", 20}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TurnedCells, AreNoneOfOtherSolids) {
  for (const char* name : {"block", "drilled", "grooved", "spring", "round_corner"})
    EXPECT_FALSE(turned_cells(geometry::test::made_brep(name))) << name;
}

}  // namespace
}  // namespace isopatch::segmentation
