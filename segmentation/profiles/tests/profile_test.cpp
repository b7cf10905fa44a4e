#include "segmentation/profiles/profile.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation {
namespace {

using drawings::Drawing;

/// A square of 4 with a circle of radius 1 taken out.
Profile holed_square() {
  Drawing drawing;
  const std::vector<int> outer = drawing.rectangle(0, 0, 4, 4);
  drawing.region({outer, {~drawing.circle({2, 2}, 1)}});
  return drawing.profile;
}

TEST(Profile, AreasHaveTheSignOfTheirLoops) {
  const Profile profile = holed_square();
  const auto& loops = profile.regions[0].loops;
  EXPECT_EQ(twice_area(profile, loops[0]), 32);
  // The polygon in the circle: of 42 sides, n / 2 sin(2 pi / n) of it.
  const double sides = static_cast<double>(profile.edges[4].points.size() - 1);
  EXPECT_NEAR(twice_area(profile, loops[1]), -sides * std::sin(2 * std::numbers::pi / sides), 1e-13);
}

struct ProfileBreach {
  const char* words;
  void (*make)(Profile& profile);
};

TEST(Profile, BreachesAreNamed) {
  validate(holed_square());
  const ProfileBreach breaches[] = {
      {"a vertex is not finite", [](Profile& p) { p.vertices[1].y() = std::nan(""); }},
      {"edge 2 runs from vertex 2 to 4 of 4", [](Profile& p) { p.edges[2].end = 4; }},
      {"edge 2 runs from vertex -1 to 3 of 4", [](Profile& p) { p.edges[2].start = -1; }},
      {"edge 1 has 1 points; a line needs 2", [](Profile& p) { p.edges[1].points.resize(1); }},
      {"edge 4 has 3 points; a line needs 2, a closed curve 4",
       [](Profile& p) { p.edges[4].points.resize(3); }},
      {"edge 3 has a point that is not finite",
       [](Profile& p) { p.edges[3].points[0].x() = std::numeric_limits<double>::infinity(); }},
      {"edge 4 has a point twice, number 6", [](Profile& p) { p.edges[4].points[7] = p.edges[4].points[6]; }},
      {"edge 0 ends 0.1 from its vertices (size of the drawing 5.6",
       [](Profile& p) { p.edges[0].points[1].y() = 0.1; }},
      {"edge 4 ends", [](Profile& p) { p.edges[4].points.pop_back(); }},  // a circle that is open
      {"region 0 has no loop", [](Profile& p) { p.regions[0].loops.clear(); }},
      {"loop 1 of region 0 is empty", [](Profile& p) { p.regions[0].loops[1].clear(); }},
      {"loop 0 of region 0 uses edge 5 of 5", [](Profile& p) { p.regions[0].loops[0][2].edge = EdgeId(5); }},
      {"loop 0 of region 0 is open after edge 2", [](Profile& p) { p.regions[0].loops[0].pop_back(); }},
      {"loop 1 of region 0 is open after edge 4",
       [](Profile& p) { p.regions[0].loops[1].push_back(p.regions[0].loops[1][0]); }},
      {"loop 1 of region 0 runs the wrong way round",
       [](Profile& p) { p.regions[0].loops[1][0].reversed = false; }},
      {"loop 0 of region 0 runs the wrong way round",
       [](Profile& p) { std::swap(p.regions[0].loops[0], p.regions[0].loops[1]); }},
  };
  for (const auto& [words, make] : breaches) {
    Profile broken = holed_square();
    make(broken);
    EXPECT_ERROR(validate(broken), ErrorCode::bad_format, words);
  }
}

TEST(Profile, EndsMayBeAsFarFromVerticesAsSixDigitsAre) {
  Profile rough = holed_square();
  rough.edges[0].points[1].y() = 5e-6;  // of 5.66, the diagonal
  validate(rough);
  rough.edges[0].points[1].y() = 6e-6;
  EXPECT_ERROR(validate(rough), ErrorCode::bad_format, "edge 0 ends 6e-06");
}

TEST(QuadrangulationOptions, OutOfRangeIsNamed) {
  validate(QuadrangulationOptions{});
  const std::pair<const char*, QuadrangulationOptions> wrong[] = {
      {"smallest_angle is 0.5, allowed is 1 to 60", {.smallest_angle = Angle::degrees(0.5)}},
      {"largest_angle is 180, allowed is 120 to 175", {.largest_angle = Angle::degrees(180)}},
      {"largest_turn is 40, allowed is 60 to 180", {.largest_turn = Angle::degrees(40)}},
      {"smallest_jacobian is 0.6, allowed is 0 to 0.5", {.smallest_jacobian = 0.6}},
      {"angle_weight is -1,", {.angle_weight = -1}},
      {"turn_weight is nan,", {.turn_weight = std::nan("")}},
      {"length_weight is -1,", {.length_weight = -1}},
      {"aspect_weight is -1,", {.aspect_weight = -1}},
      {"slant_weight is inf,", {.slant_weight = std::numeric_limits<double>::infinity()}},
      {"effort is -1, allowed is 0", {.effort = -1}}};
  for (const auto& each : wrong) EXPECT_ERROR(validate(each.second), ErrorCode::invalid_argument, each.first);
}

}  // namespace
}  // namespace isopatch::segmentation
