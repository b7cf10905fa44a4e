#include "segmentation/turned/turned_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

/// With the carriers of what a file has as splines, as solids are cut.
Brep solid_of(const std::string& name) {
  return geometry::recognise_carriers(geometry::test::made_brep(name)).brep;
}

struct Sample {
  const char* name;
  int hexahedra;  ///< at most
  double off = 1e-9;
};

class TurnedCellsOf : public testing::TestWithParam<Sample> {};

TEST_P(TurnedCellsOf, FillTheSolidAndMeetSideToSide) {
  const Brep solid = solid_of(GetParam().name);
  const auto turned = turned_cells(solid);
  ASSERT_TRUE(turned);
  EXPECT_LE(static_cast<int>(turned->complex.cells.size()), GetParam().hexahedra);
  test::expect_sound(solid, turned->complex, GetParam().off);
}

INSTANTIATE_TEST_SUITE_P(
    Solids, TurnedCellsOf,
    testing::Values(Sample{"sphere", 7}, Sample{"sphere_splines", 7}, Sample{"torus_splines", 20},
                    Sample{"torus", 20}, Sample{"cylinder", 5}, Sample{"cone", 5}, Sample{"shaft", 19},
                    Sample{"ring_quarter", 1}, Sample{"ring_150", 2}, Sample{"cone_quarter", 1},
                    Sample{"shell_piece", 1}, Sample{"elbow_piece", 1}, Sample{"ball_on_rod", 11, 1e-7},
                    Sample{"bored_ball", 16}, Sample{"hollow_ball", 6}, Sample{"domed_rod", 11},
                    Sample{"round_cup", 9}, Sample{"flat_cup", 9}, Sample{"ring_in_halves", 8},
                    Sample{"sheave", 36}, Sample{"round_ring", 44}, Sample{"bent_rod", 10},
                    Sample{"bent_tube", 4}, Sample{"half_torus", 10}, Sample{"vessel_head", 5},
                    Sample{"half_shaft", 18}, Sample{"quarter_shaft", 3}, Sample{"three_quarters", 12},
                    Sample{"half_dome", 20}),
    [](const auto& info) { return std::string(info.param.name); });

double volume_of(const Brep& solid, const CellComplex& complex) {
  double volume = 0;
  for (const Brep& cell : geometry::cell_solids(solid, complex)) volume += cell.volume();
  return volume;
}

TEST(TurnedCells, HaveTheClosedFormOfTheirVolume) {
  constexpr double pi = std::numbers::pi;
  // A ball of radius 6 and a rod of radius 3, whose joint the CAD program has to 2e-8.
  const double joint = std::sqrt(27.0), cap = pi * (6 - joint) * (6 - joint) * (12 + joint) / 3;
  const std::vector<std::pair<const char*, double>> known = {
      {"torus", 2 * pi * pi * 90},
      {"bent_tube", 5 * pi * pi * 6},
      {"vessel_head", 2 * pi / 3 * (500 - 324)},
      {"hollow_ball", 4 * pi / 3 * (512 - 125)},
      {"ball_on_rod", 4 * pi / 3 * 216 + 9 * pi * (20 - joint) - cap}};
  for (const auto& [name, volume] : known) {
    const Brep solid = solid_of(name);
    EXPECT_NEAR(1e9 * volume_of(solid, turned_cells(solid)->complex) / volume, 1, 1e-12) << name;
  }
}

TEST(TurnedCells, SayWhatTheyWereTurnedAbout) {
  const auto ball =
      turned_cells(geometry::test::made_brep("ball_on_rod"));  // whose ball has an axis of its own
  EXPECT_NEAR(std::abs(ball->about.x()), 1, 1e-12);
  EXPECT_EQ(ball->sectors, 4);
  EXPECT_NEAR(ball->sweep, 2 * std::numbers::pi, 1e-12);
  const auto bent = turned_cells(geometry::test::made_brep("bent_rod"));
  EXPECT_NEAR(bent->about.dot(Eigen::Vector3d(0, 0.6, 0.8)), 1, 1e-12);
  EXPECT_EQ(bent->sectors, 2);
  EXPECT_EQ(bent->along_axis, 0);
  EXPECT_NEAR(bent->sweep, 2 * std::numbers::pi / 3, 1e-9);
}

TEST(TurnedCells, KeepBothHalvesOfAFaceApart) {
  const Brep solid = geometry::test::made_brep("ring_in_halves");
  ASSERT_EQ(solid.faces().size(), 10U);
  std::map<FaceId, int> pieces;
  const CellComplex complex = turned_cells(solid)->complex;
  for (const geometry::CellFace& face : complex.faces)
    if (face.origin) ++pieces[*face.origin];
  for (const auto& [face, count] : pieces) EXPECT_EQ(count % 2, 0) << face.value;
  EXPECT_EQ(pieces.size(), 10U);
}

TEST(TurnedCells, EndInNoPoint) {
  EXPECT_ERROR(turned_cells(geometry::test::made_brep("pointed_rod")), ErrorCode::unsupported,
               "comes to a point on the axis");
}

TEST(TurnedCells, HaveAsManySectorsAsPrismsAboutTheirAxis) {
  const std::vector<std::pair<const char*, int>> known = {
      {"socket_screw", 6}, {"square_end", 4}, {"twelve_sided_hole", 12}};
  for (const auto& [name, sectors] : known) {
    const Brep solid = solid_of(name);
    const auto turned = turned_cells(solid);
    ASSERT_TRUE(turned) << name;
    EXPECT_EQ(turned->sectors, sectors) << name;
    test::expect_sound(solid, turned->complex, 1e-12);
    EXPECT_GT(geometry::least_quality(turned->complex), 0.25) << name;  // what counts as good elsewhere
  }
}

TEST(TurnedCells, AreNoneOfOtherSolids) {
  for (const char* name : {"block", "drilled", "grooved", "spring", "round_corner", "odd_socket"})
    EXPECT_FALSE(turned_cells(geometry::test::made_brep(name))) << name;
}

}  // namespace
}  // namespace isopatch::segmentation
