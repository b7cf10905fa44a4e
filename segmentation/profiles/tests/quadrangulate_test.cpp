#include "segmentation/profiles/quadrangulate.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/profiles/tests/division_check.hpp"
#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation {
namespace {

using namespace drawings;

std::size_t count_of(const Profile& profile) {
  const Quadrangulation quads = quadrangulate(profile);
  EXPECT_EQ(checks::fault_of(profile, quads), "");
  const auto [smallest, largest] = checks::angles_of(profile, quads);
  EXPECT_GE(smallest, QuadrangulationOptions().smallest_angle.degrees() - 1e-6);
  EXPECT_LE(largest, QuadrangulationOptions().largest_angle.degrees() + 1e-6);
  return quads.quads.size();
}

TEST(Quadrangulate, ProfilesVerticesComeFirst) {
  const Profile profile = l_shape();
  const Quadrangulation quads = quadrangulate(profile);
  ASSERT_GE(quads.vertices.size(), profile.vertices.size());
  for (std::size_t v = 0; v < profile.vertices.size(); ++v) EXPECT_EQ(quads.vertices[v], profile.vertices[v]);
}

TEST(Quadrangulate, PolygonsAreDividedByFewChords) {
  EXPECT_EQ(count_of(square()), 1U);
  EXPECT_EQ(count_of(l_shape()), 2U);  // a chord from the reflex corner to the opposite one
  EXPECT_EQ(count_of(t_shape()), 4U);
  EXPECT_LE(count_of(h_shape()), 7U);
}

TEST(Quadrangulate, ABlockWithABoreIsFour) {
  EXPECT_EQ(count_of(row_of_bores(1)), 4U);
}

TEST(Quadrangulate, ARowOfBoresIsThreeForEachAndOneMore) {
  for (const int bores : {2, 3, 5})
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

TEST(Quadrangulate, PocketsShareTheirOutline) {
  EXPECT_LE(count_of(plate_with_pocket()), 14U);
}

}  // namespace
}  // namespace isopatch::segmentation
