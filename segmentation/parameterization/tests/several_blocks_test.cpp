// Several solids of files that become one model: half a tube, twice through the wall and twice around.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <set>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/spline_blocks.hpp"

namespace isopatch::segmentation {
namespace {

const geometry::CylinderOptions half_tube{
    .angle = Angle::degrees(180), .radial_patches = 2, .patches_around = 2};
const double volume_of_half_tube = std::numbers::pi / 2 * 3 * 0.5;

/// The four blocks as files of trimmed surfaces, and the list of their pairs.
class SeveralBlocks : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("isopatch_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model(half_tube));
    for (int p = 0; p < model.patch_count(); ++p) {
      files_.files.push_back(folder_ / fmt::format("block{}.xml", p));
      geometry::write_brep(files_.files.back(), test::solid_of(model.patch(PatchId(p))), {.unit = "m"});
    }
    for (const geometry::Interface& pair : model.interfaces()) {
      pairs_.push_back(
          {pair.first.patch.value, face_of(pair.first), pair.second.patch.value, face_of(pair.second)});
      const ListedPair& p = pairs_.back();
      list_ +=
          fmt::format("block{} {} block{} {}\n", p.first_block, p.first_face, p.second_block, p.second_face);
    }
    write_file(folder_ / "pairs.txt", list_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  // Solids have their faces in the order of the sides.
  static int face_of(const geometry::PatchFace& face) {
    return static_cast<int>(std::find(geometry::all_sides.begin(), geometry::all_sides.end(), face.side) -
                            geometry::all_sides.begin());
  }
  HexModel found() const { return read_blocks(files_).model; }
  HexModel listed() const {
    BlockFiles with_list = files_;
    with_list.pairs = folder_ / "pairs.txt";
    return read_blocks(with_list).model;
  }

  std::filesystem::path folder_;
  BlockFiles files_;
  std::vector<ListedPair> pairs_;
  std::string list_;
};

/// Pairs of faces by their names.
std::set<std::set<std::string>> named_pairs(const HexModel& model) {
  std::set<std::set<std::string>> result;
  for (const geometry::HexFace& face : model.topology.faces)
    if (face.uses.size() == 2)
      result.insert({label_of(model, face.uses[0].side), label_of(model, face.uses[1].side)});
  return result;
}

TEST_F(SeveralBlocks, GeometryFindsThePairsOfTheList) {
  EXPECT_EQ(named_pairs(listed()).size(), 4u);
  EXPECT_EQ(named_pairs(found()), named_pairs(listed()));
  EXPECT_TRUE(found().topology.t_joints.empty());
}

TEST_F(SeveralBlocks, OfOneGroupMeetInThePairsOfTheListAlone) {
  const std::vector<geometry::BrepFile> blocks = found().solids;
  const ListedPair known = pairs_[0];
  std::vector<int> groups(4, -1);
  // What is known is not looked for again, the rest is found.
  EXPECT_EQ(named_pairs(hex_model(blocks, {}, groups)), named_pairs(listed()));
  groups[static_cast<std::size_t>(known.first_block)] = groups[static_cast<std::size_t>(known.second_block)] =
      7;
  EXPECT_EQ(named_pairs(hex_model(blocks, {known}, groups)), named_pairs(listed()));
  // Two that touch though they are of one group and in no pair stay apart.
  EXPECT_EQ(named_pairs(hex_model(blocks, {}, groups)).size(), 3u);
  EXPECT_EQ(named_pairs(hex_model(blocks, {}, std::vector<int>(4, 0))).size(), 0u);
  EXPECT_THAT([&] { hex_model(blocks, {}, std::vector<int>{0}); },
              test::ThrowsError(ErrorCode::invalid_argument, {"4 solids", "groups of 1"}));
}

TEST_F(SeveralBlocks, BecomeCertifiedWatertightPatches) {
  const Parameterization made = parameterize(listed());
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  ASSERT_EQ(made.patches.patches.size(), 4u);
  EXPECT_LE(made.report.worst_face().deviation, 1e-4 * made.report.size);
  EXPECT_EQ(made.patches.interfaces.size(), 4u);
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
  const geometry::MultiPatch model = geometry::connect(made.patches);
  EXPECT_EQ(model.interfaces().size(), 4u);
  for (const auto& face : model.interfaces()) EXPECT_LT(face.gap, 1e-15);  // round-off of the comparison
  double sum = 0;
  for (const PatchReport& patch : made.report.patches) sum += patch.volume;
  EXPECT_NEAR(sum, volume_of_half_tube, 15 * made.report.tolerance);
}

TEST_F(SeveralBlocks, ThatOnlyNearlyMeetAreFittedAsFarAsTheyDo) {
  // One of four aside by 6e-4 of the size: edges of its neighbours end beside the vertices that are put
  // between them all, and no knots bring them there.
  const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model(half_tube));
  const geometry::NurbsVolume& first = model.patch(PatchId(0));
  const Eigen::Matrix3Xd moved = first.control_points().colwise() + Eigen::Vector3d(2e-3, 1e-3, 0);
  geometry::write_brep(files_.files[0],
                       test::solid_of(geometry::NurbsVolume(first.knots(), moved, first.weights())),
                       {.unit = "m"});
  const HexModel together = found();
  EXPECT_EQ(together.topology.edges.size(), listed().topology.edges.size());
  const Parameterization made = parameterize(together);
  EXPECT_LT(made.report.worst_face().deviation, 1e-3 * made.report.size);
}

TEST_F(SeveralBlocks, ThatAreExactAreNotPulledTogetherWhereTheyNearlyMeet) {
  // A fifth on top of the first, aside by 5e-4 of the size, beside four that meet to round-off.
  const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model(half_tube));
  const geometry::NurbsVolume& first = model.patch(PatchId(0));
  const Eigen::Matrix3Xd moved =
      first.control_points().colwise() + Eigen::Vector3d(2e-3, 0, half_tube.height);
  files_.files.push_back(folder_ / "block4.xml");
  geometry::write_brep(files_.files[4],
                       test::solid_of(geometry::NurbsVolume(first.knots(), moved, first.weights())),
                       {.unit = "m"});
  EXPECT_EQ(named_pairs(found()).size(), 4u);
  EXPECT_TRUE(found().topology.t_joints.empty());
  files_.assembly.same_point = 1e-3;
  EXPECT_EQ(named_pairs(found()).size(), 5u);
}

TEST_F(SeveralBlocks, ThePapersMethodDeviatesMore) {
  const Parameterization made = parameterize(listed(), test::options(ParameterizationMethod::paper));
  for (const auto& patch : made.patches.patches) EXPECT_EQ(patch.size(), 343);
  EXPECT_GT(made.report.worst_face().deviation, parameterize(listed()).report.worst_face().deviation);
  // Averages make interfaces agree to the last bit, too.
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
}

TEST_F(SeveralBlocks, WrongPairListsAreRefusedByName) {
  const std::vector<geometry::BrepFile> blocks = found().solids;
  auto pairs = pairs_;
  std::swap(pairs[0].second_face, pairs[0].first_face);
  EXPECT_THAT([&] { hex_model(blocks, pairs); },
              test::ThrowsError(ErrorCode::not_conforming, {"pair 0", "do not meet"}));
  pairs = pairs_;
  pairs[1] = pairs[0];
  EXPECT_THAT([&] { hex_model(blocks, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"block0:", "pair 0 and in pair 1"}));
  pairs = pairs_;
  pairs[0].first_block = 9;
  EXPECT_THAT([&] { hex_model(blocks, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"block 9", "there are 4"}));
  pairs[0] = {0, 6, 1, 0};
  EXPECT_THAT([&] { hex_model(blocks, pairs); },
              test::ThrowsError(ErrorCode::invalid_argument, {"has no face 6"}));
}

TEST_F(SeveralBlocks, AreRefusedWithWhatDoesNotFitThem) {
  const std::vector<geometry::BrepFile> blocks = found().solids;
  EXPECT_THAT(
      [&] {
        hex_model(blocks, pairs_, std::vector<int>{0, 0, 1}, {});
      },
      test::ThrowsError(ErrorCode::invalid_argument, {"4 solids come with the groups of 3"}));
  EXPECT_THAT([&] { hex_model(blocks, pairs_, AssemblyOptions{.same_point = 0.05}); },
              test::ThrowsError(ErrorCode::invalid_argument, {"same_point is 0.05"}));
  HexModel model = found();
  model.bodies.pop_back();
  EXPECT_THAT([&] { validate(model); }, test::ThrowsError(ErrorCode::invalid_argument,
                                                          {"4 blocks comes with 4 solids", "bodies of 3"}));
  EXPECT_THAT([&] { validate(HexModel{}); },
              test::ThrowsError(ErrorCode::invalid_argument, {"at least one hexahedron"}));
}

TEST_F(SeveralBlocks, ListsThatCannotBeReadAreRefusedWithTheLine) {
  std::vector<std::string> blocks;
  for (const geometry::BrepFile& solid : found().solids) blocks.push_back(solid.name);
  const std::vector<ListedPair> read = parse_pairs(list_, "list", blocks);
  ASSERT_EQ(read.size(), pairs_.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].first_block, pairs_[i].first_block) << i;
    EXPECT_EQ(read[i].second_face, pairs_[i].second_face) << i;
  }
  EXPECT_THAT([&] { parse_pairs("block2 1 block3 x\n", "list", blocks); },
              test::ThrowsError(ErrorCode::bad_format, {"list:1", "block face block face"}));
  EXPECT_THAT([&] { parse_pairs("\nblock2 1 blok3 2\n", "list", blocks); },
              test::ThrowsError(ErrorCode::invalid_argument, {"list:2", "'blok3'", "did you mean 'block3'"}));
}

}  // namespace
}  // namespace isopatch::segmentation
