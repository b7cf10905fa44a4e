#include "segmentation/branches/branched_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/flat_tips.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/brep/without_faces.hpp"
#include "segmentation/branches/cross_bored_cells.hpp"
#include "segmentation/branches/internal/bore_room.hpp"
#include "segmentation/branches/internal/cross_bores.hpp"
#include "segmentation/branches/internal/own_columns.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

struct Made {
  geometry::CellComplex complex;
  int branches = 0;
  int slots = 0;  ///< among them
};

/// Cells of a body with what branches off from it.
std::optional<Made> branched(const geometry::Brep& solid) {
  const auto made = branched_cells(solid);
  return made ? std::optional(Made{made->complex, made->branches, 0}) : std::nullopt;
}

/// Cells of a stack with bores across it.
std::optional<Made> cross_bored(const geometry::Brep& solid) {
  const auto made = cross_bored_cells(solid);
  return made ? std::optional(Made{made->complex, made->bores, made->slots}) : std::nullopt;
}

struct Sample {
  const char* name;
  std::size_t hexahedra;  ///< at most
  int branches;
  std::optional<Made> (*cells)(const geometry::Brep&) = branched;
  double least_quality = 0;
  int slots = 0;
};

class SolidsWithBranches : public testing::TestWithParam<Sample> {};

/// Where cylinders cross, CAD programs have splines in their place, to 1e-7.
constexpr double off_where_crossed = 1e-6;

TEST_P(SolidsWithBranches, AreFilledWithCellsThatMeetSideToSide) {
  const geometry::Brep solid = geometry::test::made_brep(GetParam().name);
  const auto made = GetParam().cells(solid);
  ASSERT_TRUE(made);
  EXPECT_LE(made->complex.cells.size(), GetParam().hexahedra);
  EXPECT_EQ(made->branches, GetParam().branches);
  EXPECT_EQ(made->slots, GetParam().slots);
  EXPECT_GT(geometry::least_quality(made->complex), GetParam().least_quality);
  test::expect_sound(solid, made->complex, off_where_crossed);
}

const auto name_of_sample = [](const auto& info) { return std::string(info.param.name); };

INSTANTIATE_TEST_SUITE_P(Branched, SolidsWithBranches,
                         testing::Values(Sample{"bossed_bar", 44, 1}, Sample{"bossed_oblique", 44, 1},
                                         Sample{"tapped_boss", 73, 1}, Sample{"two_bosses", 83, 2},
                                         Sample{"cross_bored", 24, 1}, Sample{"beside_the_axis", 24, 1},
                                         Sample{"oil_bore", 15, 1}, Sample{"pinned_tube", 18, 2},
                                         Sample{"grooved_bushing", 40, 4, branched, 0.1},
                                         Sample{"sunk_bar", 62, 1}, Sample{"keyed_bar", 116, 1},
                                         Sample{"tee", 20, 1}, Sample{"boss_near_the_end", 39, 1},
                                         Sample{"oil_bores_at_120", 30, 3}, Sample{"bolted_cap", 30, 2},
                                         Sample{"bolted_close", 60, 4, branched, 0.2}),
                         name_of_sample);

INSTANTIATE_TEST_SUITE_P(
    CrossBored, SolidsWithBranches,
    testing::Values(
        Sample{"port", 21, 1, cross_bored, 0.2}, Sample{"ports", 24, 2, cross_bored, 0.2},
        Sample{"three_bores", 60, 4, cross_bored, 0.2}, Sample{"sunk_port", 60, 1, cross_bored, 0.2},
        Sample{"blind_bore", 70, 1, cross_bored, 0.2}, Sample{"slotted_bar", 14, 1, cross_bored, 0.2},
        Sample{"slotted_wing", 9, 1, cross_bored, 0.2, 1},
        Sample{"pocketed_wing", 21, 1, cross_bored, 0.2, 1},
        Sample{"slotted_lens", 14, 1, cross_bored, 0.2, 1}, Sample{"bored_lens", 9, 1, cross_bored, 0.2},
        Sample{"flatted_pin", 160, 1, cross_bored, 0.2}, Sample{"vee_block", 42, 2, cross_bored, 0.2},
        Sample{"rod_fork", 40, 1, cross_bored, 0.2}, Sample{"bored_rod_fork", 40, 1, cross_bored, 0.2},
        Sample{"nozzle", 60, 1, cross_bored, 0.2}, Sample{"greased_bar", 24, 1, cross_bored, 0.2},
        Sample{"keyed_hub", 90, 1, cross_bored, 0.2}),
    name_of_sample);

// The tip's levels bend away from the bore across, which is at the height of one.
TEST(CrossBoredCells, LieBesideATip) {
  const geometry::Brep pointed = geometry::test::made_brep("tipped_gallery");
  const geometry::Brep solid = geometry::with_flat_tips(pointed, geometry::drill_tips(pointed), 0.25);
  const auto made = cross_bored_cells(solid);
  ASSERT_TRUE(made);
  EXPECT_LE(made->complex.cells.size(), 38U);
  EXPECT_GT(geometry::least_quality(made->complex), 0.2);
  test::expect_sound(solid, made->complex, off_where_crossed);
}

/// How long the longest line of a block's drawing is along y, in the block's size.
double longest_line(FloorLines floors) {
  const geometry::Brep solid = geometry::test::made_brep("blind_bore");
  const auto bores = *cross_bores(solid, Eigen::Vector3d::UnitX());
  const geometry::Brep blank = geometry::without_faces(solid, bores.front().faces);
  for (const SweepFrame& frame : sweep_frames(blank)) {
    if (std::abs(frame.along.x()) < 0.5) continue;
    double result = 0;
    for (const Line& line : bore_room(solid, blank, frame, bores, floors).lines)
      result = larger(result, std::abs((line[1] - line[0]).y()) / blank.size());
    return result;
  }
  return 0;
}

// The bore's floor is at right angles to its axis z: its line runs along y.
TEST(CrossBoredCells, MayHaveFloorsNoLongerThanTheRoomBesideThem) {
  EXPECT_GT(longest_line(FloorLines::through_all), 1);
  EXPECT_LT(longest_line(FloorLines::between_planes), 0.6);
  EXPECT_GT(longest_line(FloorLines::between_planes), 0);
}

/// The lines of a solid's own columns, and whether they end at corners.
OwnColumns columns_of(const char* name, const Eigen::Vector3d& along) {
  const geometry::Brep solid = geometry::test::made_brep(name);
  const auto bores = *cross_bores(solid, along);
  const geometry::Brep blank = geometry::without_faces(solid, bores.front().faces);
  return own_columns(solid, blank, sweep_frames(blank).front(), bores);
}

// From the flat's corners at x = +-sqrt(20^2 - 17^2) to the bore, 45 degrees from the hole.
TEST(OwnColumns, LeadFromTheCornersOfAFlatToTheBore) {
  const OwnColumns columns = columns_of("greased_bar", Eigen::Vector3d::UnitY());
  EXPECT_TRUE(columns.end_at_corners);
  ASSERT_EQ(columns.lines.size(), 2U);
  for (const Line& line : columns.lines) {
    EXPECT_NEAR(std::abs(line[0].x()), std::sqrt(111.0) * 1e-3, 1e-8);
    EXPECT_NEAR(line[0].z(), 0.017, 1e-8);
    EXPECT_NEAR(line[1].z(), 0.011 * std::sqrt(0.5), 1e-8);
  }
}

TEST(OwnColumns, EndBesideBoresWhereNoCornerIsNear) {
  const OwnColumns columns = columns_of("blind_bore", Eigen::Vector3d::UnitX());
  EXPECT_FALSE(columns.end_at_corners);
  double widest = 0;
  for (const Line& line : columns.lines) widest = larger(widest, std::abs(line[0].y() - 0.02));
  EXPECT_NEAR(widest, 0.008, 1e-8);
}

TEST(BranchedCells, AreNoneOfSolidsWithoutATurnedBody) {
  for (const char* name : {"block", "cylinder", "drilled", "fork"})
    EXPECT_FALSE(branched_cells(geometry::test::made_brep(name))) << name;
}

TEST(BranchedCells, SayForWhichBranchThereIsNoRoom) {
  EXPECT_ERROR(branched_cells(geometry::test::made_brep("wide_boss")), ErrorCode::unsupported, "too wide");
  EXPECT_ERROR(branched_cells(geometry::test::made_brep("boss_at_the_end")), ErrorCode::unsupported,
               "too near to the end of its cylinder");
}

TEST(BranchedCells, SayWhatTheBodyIsTurnedAbout) {
  const auto made = branched_cells(geometry::test::made_brep("bossed_oblique"));
  EXPECT_NEAR(std::abs(made->about.dot(Eigen::Vector3d(2, 3, 6) / 7)), 1, 1e-12);
}

TEST(CrossBoredCells, AreNoneOfSolidsWithoutBoresAcross) {
  for (const char* name : {"block", "shaft", "bossed_bar"})
    EXPECT_FALSE(cross_bored_cells(geometry::test::made_brep(name))) << name;
}

TEST(CrossBoredCells, SayWhichBoreIsWiderThanTheOneItEndsIn) {
  EXPECT_ERROR(cross_bored_cells(geometry::test::made_brep("wide_port")), ErrorCode::unsupported, "wide");
}

}  // namespace
}  // namespace isopatch::segmentation
