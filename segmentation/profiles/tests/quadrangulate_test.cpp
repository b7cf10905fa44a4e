#include "segmentation/profiles/quadrangulate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/profiles/division_error.hpp"
#include "segmentation/profiles/tests/division_check.hpp"
#include "segmentation/profiles/tests/drawing.hpp"
#include "segmentation/profiles/tests/random_drawing.hpp"

namespace isopatch::segmentation {
namespace {

using namespace drawings;

std::size_t count_of(const Profile& profile) {
  const Quadrangulation quads = quadrangulate(profile, {.thorough = true});
  EXPECT_EQ(checks::fault_of(profile, quads), "");
  const auto [smallest, largest] = checks::angles_of(profile, quads);
  EXPECT_GE(smallest, QuadrangulationOptions().smallest_angle.degrees() - 1e-6);
  EXPECT_LE(largest, QuadrangulationOptions().largest_angle.degrees() + 1e-6);
  return quads.quads.size();
}

TEST(Quadrangulate, ProfilesVerticesComeFirst) {
  const Profile profile = l_shape();
  const Quadrangulation quads = quadrangulate(profile, {.thorough = true});
  ASSERT_GE(quads.vertices.size(), profile.vertices.size());
  for (std::size_t v = 0; v < profile.vertices.size(); ++v) EXPECT_EQ(quads.vertices[v], profile.vertices[v]);
}

TEST(Quadrangulate, PolygonsAreDividedByFewChords) {
  EXPECT_EQ(count_of(square()), 1U);
  EXPECT_EQ(count_of(l_shape()), 2U);  // a chord from the reflex corner to the opposite one
  EXPECT_EQ(count_of(t_shape()), 4U);
  EXPECT_LE(count_of(h_shape()), 7U);
}

// Between two sides of a square and the arc that touches both: two of its corners have no angle.
TEST(Quadrangulate, SaysWhereARegionCannotBeDivided) {
  Profile profile;
  profile.vertices = {{7, 3}, {9, 3}, {9, 5}};
  profile.edges = {{0, 1, {profile.vertices[0], profile.vertices[1]}},
                   {1, 2, {profile.vertices[1], profile.vertices[2]}},
                   {0, 2, {}}};
  for (int i = 0; i <= 24; ++i) {
    const double angle = std::numbers::pi / 2 * i / 24;
    profile.edges[2].points.emplace_back(7 + 2 * std::sin(angle), 5 - 2 * std::cos(angle));
  }
  profile.regions = {{{{{EdgeId(0), false}, {EdgeId(1), false}, {EdgeId(2), true}}}}};
  try {
    quadrangulate(profile);
    FAIL() << "it was divided";
  } catch (const DivisionError& error) {
    EXPECT_EQ(error.region(), 0);
    EXPECT_LT(std::min((error.place() - Eigen::Vector2d(7, 3)).norm(),
                       (error.place() - Eigen::Vector2d(9, 5)).norm()),
              1);
  }
}

// What is finished of a draft is what is divided at once, which costs no more than the draft.
TEST(DraftedQuadrangulation, IsFinishedAsQuadrangulateDoes) {
  const Profile profile = drawings::plate_with_pocket();
  const QuadrangulationOptions options{.thorough = true};
  const DraftedQuadrangulation draft(profile, options);
  const Quadrangulation finished = draft.finished(), at_once = quadrangulate(profile, options);
  EXPECT_LE(static_cast<double>(finished.quads.size()), draft.cost());
  EXPECT_EQ(finished.vertices, at_once.vertices);
  EXPECT_EQ(finished.quads.size(), at_once.quads.size());
}

TEST(Quadrangulate, ABlockWithABoreIsFour) {
  EXPECT_EQ(count_of(row_of_bores(1)), 4U);
}

TEST(Quadrangulate, ARowOfBoresIsThreeForEachAndOneMore) {
  for (const int bores : {2, 3, 4, 5})
    EXPECT_LE(count_of(row_of_bores(bores)), 3U * bores + 1) << bores << " bores";
}

TEST(Quadrangulate, RoundSectionsHaveACore) {
  EXPECT_EQ(count_of(disc()), 5U);
  EXPECT_EQ(count_of(half_disc()), 4U);
  EXPECT_EQ(count_of(quarter_disc()), 3U);
  EXPECT_EQ(count_of(d_shape(0.5)), 4U);
}

TEST(Quadrangulate, RingsAreQuartered) {
  EXPECT_EQ(count_of(ring(0.3)), 4U);
  EXPECT_EQ(count_of(ring(0.8)), 4U);
}

TEST(Quadrangulate, ConcentricRegionsShareDirections) {
  EXPECT_EQ(count_of(concentric(3)), 5U + 4U + 4U);
}

TEST(Quadrangulate, SmoothOutlinesGetARing) {
  EXPECT_EQ(count_of(slot(1)), 8U);
  EXPECT_EQ(count_of(rounded_plate()), 11U);
}

TEST(Quadrangulate, RandomDrawingsAreDividedWithinTheRules) {
  QuadrangulationOptions options;
  options.effort = 10;
  for (unsigned seed = 300; seed < 325; ++seed) {
    const Profile profile = RandomDrawing(seed).draw();
    const Quadrangulation quads = quadrangulate(profile, options);
    EXPECT_EQ(checks::fault_of(profile, quads), "") << "seed " << seed;
    const auto [smallest, largest] = checks::angles_of(profile, quads);
    EXPECT_GE(smallest, options.smallest_angle.degrees() - 1e-6) << "seed " << seed;
    EXPECT_LE(largest, options.largest_angle.degrees() + 1e-6) << "seed " << seed;
  }
}

TEST(Quadrangulate, IsTheSameWhereverTheDrawingLies) {
  Profile profile = row_of_bores(1);
  const Eigen::Rotation2Dd turn(0.3);
  for (Vector2d& vertex : profile.vertices) vertex = 1e3 * (turn * vertex) + Vector2d(5e3, -2e3);
  for (ProfileEdge& edge : profile.edges)
    for (Vector2d& point : edge.points) point = 1e3 * (turn * point) + Vector2d(5e3, -2e3);
  EXPECT_EQ(quadrangulate(profile).quads.size(), 4U);
}

TEST(Quadrangulate, ThinBentSheetsAreOneQuadrilateralEach) {
  EXPECT_EQ(count_of(thin_sheets(1, 1, 0.75)), 1U);
  EXPECT_EQ(count_of(thin_sheets(4, 1, 0.75)), 4U);
}

TEST(Quadrangulate, ThinSheetsAreCutAtTheirLegs) {
  // The sheet in three and two legs, the outer sheet in three; no angle is far from right.
  const Profile profile = sheet_with_legs(0.75, 8, 50);
  EXPECT_LE(count_of(profile), 8U);
  EXPECT_GE(checks::angles_of(profile, quadrangulate(profile, {.thorough = true})).first, 80);
}

TEST(Quadrangulate, UnwantedRegionsStayEmpty) {
  Profile profile = plate_with_pocket();
  profile.regions[1].wanted = false;
  const Quadrangulation quads = quadrangulate(profile);
  EXPECT_EQ(checks::fault_of(profile, quads), "");
  for (const Quad& quad : quads.quads) EXPECT_EQ(quad.region, 0);
}

TEST(Quadrangulate, RefusesLoopsThatCross) {
  Drawing drawing;
  const auto out = drawing.rectangle(0, 0, 2, 2);
  drawing.region({out, {~drawing.circle({2, 1}, 0.5)}});
  EXPECT_ERROR(quadrangulate(drawing.profile), ErrorCode::unsupported, "region 0");
}

TEST(Quadrangulate, RefusesOpenLoopsAndWrongWaysRound) {
  Profile profile = square();
  profile.regions[0].loops[0].pop_back();
  EXPECT_ERROR(quadrangulate(profile), ErrorCode::bad_format, "open after edge 2");
  Drawing drawing;
  drawing.region({Drawing::backwards(drawing.rectangle(0, 0, 1, 1))});
  EXPECT_ERROR(quadrangulate(drawing.profile), ErrorCode::bad_format, "wrong way round");
}

TEST(Quadrangulate, OptionsNameFieldAndRange) {
  QuadrangulationOptions options;
  options.smallest_angle = Angle::degrees(70);
  EXPECT_ERROR(quadrangulate(square(), options), ErrorCode::invalid_argument,
               "smallest_angle is 70, allowed is 1 to 60");
}

// Prints the README's table: --gtest_also_run_disabled_tests --gtest_filter=*TableOfTheReadme
TEST(Quadrangulate, DISABLED_TableOfTheReadme) {
  const std::vector<std::pair<const char*, Profile>> all = {
      {"square", square()},
      {"L", l_shape()},
      {"T", t_shape()},
      {"H", h_shape()},
      {"plate, 1 bore", row_of_bores(1)},
      {"plate, row of 2 bores", row_of_bores(2)},
      {"plate, row of 3", row_of_bores(3)},
      {"plate, row of 4", row_of_bores(4)},
      {"plate, row of 5", row_of_bores(5)},
      {"plate, 8 x 5 bores", grid_of_bores(8, 5)},
      {"disc", disc()},
      {"half a disc", half_disc()},
      {"quarter of a disc", quarter_disc()},
      {"D", d_shape(0.5)},
      {"ring", ring(0.3)},
      {"disc in two rings", concentric(3)},
      {"slot", slot(1)},
      {"plate with a slot", plate_with_slot()},
      {"plate with a pocket, both divided", plate_with_pocket()},
      {"plate with a smooth pocket, both divided", plate_with_smooth_pocket()},
      {"strips, two bores in one", strips_with_bores()},
      {"plate with round corners", rounded_plate()},
      {"thin frame with round inner corners", frame(0.1, 0.3)},
      {"4 thin sheets, bent", thin_sheets(4, 1, 0.75)},
      {"thin sheet with legs, and one outside", sheet_with_legs(0.75, 8, 50)},
      {"shaft with a keyway", keyway()},
      {"flange, bore and 6 holes", flange(6, true)},
      {"flange, bore and 8 holes", flange(8, true)},
      {"gear, 8 teeth, bore", gear(8)},
      {"gear, 16 teeth, bore", gear(16)},
      {"bearing plate, 5 bores", bearing_plate()}};
  fmt::print("| profile | quadrilaterals | smallest angle | largest angle |\n|---|---:|---:|---:|\n");
  for (const auto& [name, profile] : all) {
    const Quadrangulation quads = quadrangulate(profile);
    const auto [smallest, largest] = checks::angles_of(profile, quads);
    fmt::print("| {} | {} | {:.0f} | {:.0f} |\n", name, quads.quads.size(), smallest, largest);
  }
}

TEST(Quadrangulate, PocketsShareTheirOutline) {
  EXPECT_LE(count_of(plate_with_pocket()), 14U);
}

TEST(Quadrangulate, SmoothPocketsGetARing) {
  // 14: four corners and two cuts of the pocket's outline, where the plate around it wants them, six
  // quadrilaterals along it and two that they leave; 19 with cuts where the outline bends.
  EXPECT_LE(count_of(plate_with_smooth_pocket()), 14U);
}

TEST(Quadrangulate, SharedEdgesAreCutOppositeBores) {
  const Profile profile = strips_with_bores();
  EXPECT_LE(count_of(profile), 24U);
  EXPECT_GE(checks::angles_of(profile, quadrangulate(profile, {.thorough = true})).first, 25);  // 15 without
}

}  // namespace
}  // namespace isopatch::segmentation
