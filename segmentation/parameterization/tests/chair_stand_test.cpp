#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/read_brep.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/gismo_solids.hpp"

namespace isopatch::segmentation {
namespace {

std::filesystem::path folder() {
  return isopatch::test::data_file("chair_stand/solids");
}

std::filesystem::path list_of_pairs() {
  return folder() / "segmented_objStandFiveParts_pairs.txt";
}

HexModel from_files(bool with_list) {
  BlockFiles files;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".xml") files.files.push_back(entry.path());
  std::sort(files.files.begin(), files.files.end());
  if (with_list) files.pairs = list_of_pairs();
  return read_blocks(files).model;
}

/// Pairs of faces by their names.
std::set<std::set<std::string>> pairs_of(const HexModel& model) {
  std::set<std::set<std::string>> result;
  for (const geometry::HexFace& face : model.topology.faces)
    if (face.uses.size() == 2)
      result.insert({label_of(model, face.uses[0].side), label_of(model, face.uses[1].side)});
  return result;
}

TEST(ChairStand, GeometryFindsThePairsOfTheList) {
  ISOPATCH_NEEDS(folder());
  const HexModel listed = from_files(true);
  const HexModel found = from_files(false);
  EXPECT_EQ(pairs_of(listed).size(), 10u);
  EXPECT_EQ(pairs_of(found), pairs_of(listed));
  EXPECT_TRUE(found.topology.t_joints.empty());
  // V - E + F - C of a solid with two openings, the slot and the caster's bore.
  EXPECT_EQ(found.topology.vertex_count - static_cast<int>(found.topology.edges.size()) +
                static_cast<int>(found.topology.faces.size()) - 9,
            -1);
}

TEST(ChairStand, BecomesNineCertifiedWatertightPatches) {
  ISOPATCH_NEEDS(folder());
  const Parameterization made = parameterize(from_files(true));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  ASSERT_EQ(made.patches.patches.size(), 9u);
  for (const PatchReport& patch : made.report.patches) EXPECT_GT(patch.quality.min_scaled_jacobian, 0.7);
  EXPECT_LE(made.report.worst_face().deviation, 1e-4 * made.report.size);
  EXPECT_EQ(made.patches.interfaces.size(), 10u);
  // Exactly the points at interfaces agree, and no others are close.
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
  const geometry::MultiPatch model = geometry::connect(made.patches);
  EXPECT_EQ(model.interfaces().size(), 10u);
  for (const auto& face : model.interfaces()) EXPECT_LT(face.gap, 1e-15);  // round-off of the comparison
}

TEST(ChairStand, VolumesAreThoseOfTheSolids) {
  ISOPATCH_NEEDS(folder());
  const Parameterization made = parameterize(from_files(true));
  double sum = 0;
  for (const PatchReport& patch : made.report.patches) sum += patch.volume;
  double solids = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".xml") solids += geometry::read_brep(entry.path()).brep.volume();
  // The surface, about 2, times the outlines' gaps of the input, 7e-4 at a few edges.
  EXPECT_NEAR(sum, solids, 2e-3 * solids);
}

TEST(ChairStand, AnotherReaderSeesTheSameFaces) {
  ISOPATCH_NEEDS(folder());
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() != ".xml") continue;
    const geometry::BrepFile solid = geometry::read_brep(entry.path());
    const std::vector<test::PlainFace> faces = test::gismo_faces(entry.path().string());
    ASSERT_EQ(faces.size(), solid.brep.faces().size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      EXPECT_EQ(faces[f].curves.size(), solid.brep.faces()[f].loops.front().size());
      for (const auto& curve : faces[f].curves)
        for (const double t : {0.1, 0.5, 0.8}) {
          const Eigen::Vector3d point = faces[f].surface(curve(t));
          EXPECT_LT(solid.brep.project(FaceId(static_cast<int>(f)), point).distance, 1e-7)
              << entry.path() << f;
        }
    }
  }
}

TEST(ChairStand, ThePapersMethodDeviatesMore) {
  ISOPATCH_NEEDS(folder());
  const Parameterization made = parameterize(from_files(true), test::options(ParameterizationMethod::paper));
  for (const auto& patch : made.patches.patches) EXPECT_EQ(patch.size(), 343);
  EXPECT_GT(made.report.worst_face().deviation, 1e-4 * made.report.size);
  // Averages make interfaces agree to the last bit, too.
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
}

TEST(ChairStand, WrongPairListsAreRefusedByName) {
  ISOPATCH_NEEDS(folder());
  const HexModel model = from_files(true);
  std::vector<std::string> names;
  for (const geometry::BrepFile& solid : model.solids) names.push_back(solid.name);
  const auto sound = parse_pairs(read_file(list_of_pairs()), "list", names);
  auto pairs = sound;
  pairs[3].second_face = (pairs[3].second_face + 1) % 6;
  EXPECT_THAT([&] { hex_model(model.solids, pairs); },
              test::ThrowsError(ErrorCode::not_conforming, {"pair 3", "do not meet"}));
  pairs = sound;
  pairs[1] = pairs[0];
  EXPECT_THAT([&] { hex_model(model.solids, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"pair 0 and in pair 1"}));
  pairs = sound;
  pairs[0].first_block = 9;
  EXPECT_THAT([&] { hex_model(model.solids, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"block 9", "there are 9"}));
  pairs[0] = {0, 6, 1, 0};
  EXPECT_THAT([&] { hex_model(model.solids, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"has no face 6"}));
}

TEST(PairLists, LinesThatAreNoPairsAreRefused) {
  const std::vector<std::string> blocks = {"Parts2", "Parts3"};
  EXPECT_THAT([&] { parse_pairs("Parts2 1 Parts3 x\n", "list", blocks); },
              test::ThrowsError(ErrorCode::bad_format, {"list:1", "block face block face"}));
  EXPECT_THAT([&] { parse_pairs("\nParts2 1 Part3 2\n", "list", blocks); },
              test::ThrowsError(ErrorCode::invalid_argument, {"list:2", "'Part3'", "did you mean 'Parts3'"}));
}

}  // namespace
}  // namespace isopatch::segmentation
