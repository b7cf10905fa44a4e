#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/read_brep.hpp"
#include "segmentation/parameterization/assemble_complex.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/gismo_solids.hpp"

namespace isopatch::segmentation {
namespace {

std::filesystem::path folder() {
  return isopatch::test::data_file("chair_stand/solids");
}

HexComplex from_brep_files(bool with_list) {
  BlockFiles files;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".xml") files.files.push_back(entry.path());
  std::sort(files.files.begin(), files.files.end());
  if (with_list) files.pairs = folder() / "segmented_objStandFiveParts_pairs.txt";
  return read_blocks(files).complex;
}

/// Pairs of faces by their names.
std::set<std::set<std::string>> pairs_of(const HexComplex& complex) {
  std::set<std::set<std::string>> result;
  for (const ComplexFace& face : complex.faces)
    if (face.uses.size() == 2)
      result.insert({complex.label(face.uses[0].side), complex.label(face.uses[1].side)});
  return result;
}

TEST(ChairStand, GeometryFindsThePairsOfTheList) {
  ISOPATCH_NEEDS(folder());
  const HexComplex listed = from_brep_files(true);
  const HexComplex found = from_brep_files(false);
  EXPECT_EQ(pairs_of(listed).size(), 10u);
  EXPECT_EQ(pairs_of(found), pairs_of(listed));
  EXPECT_TRUE(found.partial_contacts.empty());
  // V - E + F - C of a solid with two openings, the slot and the caster's bore.
  EXPECT_EQ(static_cast<int>(found.vertices.size()) - static_cast<int>(found.edges.size()) +
                static_cast<int>(found.faces.size()) - 9,
            -1);
}

TEST(ChairStand, BecomesNineCertifiedWatertightPatches) {
  ISOPATCH_NEEDS(folder());
  const Parameterization made = parameterize(from_brep_files(true));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  ASSERT_EQ(made.patches.patches.size(), 9u);
  for (const PatchReport& patch : made.report.patches) EXPECT_GT(patch.quality.min_scaled_jacobian, 0.7);
  EXPECT_LE(made.report.worst_face().deviation, 1e-4 * made.report.size);
  EXPECT_EQ(made.patches.listed_interfaces.size(), 10u);
  // Exactly the points at interfaces agree, and no others are close.
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
  const geometry::MultiPatch model = geometry::connect(made.patches);
  EXPECT_EQ(model.interfaces().size(), 10u);
  for (const auto& face : model.interfaces()) EXPECT_LT(face.gap, 1e-15);  // round-off of the comparison
}

TEST(ChairStand, VolumesAreThoseOfTheSolids) {
  ISOPATCH_NEEDS(folder());
  const Parameterization made = parameterize(from_brep_files(true));
  double sum = 0;
  for (const PatchReport& patch : made.report.patches) sum += patch.volume;
  double solids = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".xml") solids += geometry::read_brep(entry.path()).brep.volume();
  // The surface, about 2, times the outlines' gaps of the input, 7e-4 at a few edges.
  EXPECT_NEAR(sum, solids, 2e-3 * solids);
}

TEST(ChairStand, AnotherReaderGivesTheSamePatches) {
  ISOPATCH_NEEDS(folder());
  const test::ChairStand plain = test::chair_stand(folder().string());
  const Parameterization made = parameterize(hex_complex(plain.blocks, plain.pairs));
  EXPECT_TRUE(made.report.usable());
  const Parameterization other = parameterize(from_brep_files(true));
  double plain_volume = 0, volume = 0;
  for (const PatchReport& patch : made.report.patches) plain_volume += patch.volume;
  for (const PatchReport& patch : other.report.patches) volume += patch.volume;
  EXPECT_NEAR(plain_volume, volume, 1e-5 * volume);
}

TEST(ChairStand, ThePapersMethodDeviatesMore) {
  ISOPATCH_NEEDS(folder());
  const Parameterization made =
      parameterize(from_brep_files(true), test::options(ParameterizationMethod::paper));
  for (const auto& patch : made.patches.patches) EXPECT_EQ(patch.size(), 343);
  EXPECT_GT(made.report.worst_face().deviation, 1e-4 * made.report.size);
  // Averages make interfaces agree to the last bit, too.
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
}

TEST(ChairStand, WrongPairListsAreRefusedByName) {
  ISOPATCH_NEEDS(folder());
  test::ChairStand plain = test::chair_stand(folder().string());
  auto pairs = plain.pairs;
  pairs[3].second_face = 0;
  EXPECT_THAT(
      [&] { hex_complex(plain.blocks, pairs); },
      test::ThrowsError(ErrorCode::not_conforming, {"pair 3", "Parts1_seed002_4:face5", "do not meet"}));
  pairs = plain.pairs;
  pairs[1] = pairs[0];
  EXPECT_THAT(
      [&] { hex_complex(plain.blocks, pairs); },
      test::ThrowsError(ErrorCode::invalid_argument, {"Parts1_seed002_3:face5", "pair 0 and in pair 1"}));
  pairs = plain.pairs;
  pairs[0].first_block = 9;
  EXPECT_THAT([&] { hex_complex(plain.blocks, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"block 9", "there are 9"}));
  pairs[0] = {0, 6, 1, 0};
  EXPECT_THAT([&] { hex_complex(plain.blocks, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"has no face 6"}));
  EXPECT_THAT([&] { parse_pairs("Parts2 1 Parts3 x\n", "list", plain.blocks); },
              test::ThrowsError(ErrorCode::bad_format, {"list:1", "block face block face"}));
  EXPECT_THAT([&] { parse_pairs("\nParts2 1 Part3 2\n", "list", plain.blocks); },
              test::ThrowsError(ErrorCode::invalid_argument, {"list:2", "'Part3'", "did you mean 'Parts3'"}));
}

}  // namespace
}  // namespace isopatch::segmentation
