#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using namespace geometry;

double volume_of(const MultiPatch& model) {
  double sum = 0;
  for (const NurbsVolume& patch : model.patches()) sum += volume(patch);
  return sum;
}

double area_of(const MultiPatch& model, const std::vector<std::pair<int, Side>>& faces) {
  double sum = 0;
  for (const auto& [patch, side] : faces) {
    const PatchFace face = model.renamed(PatchFace{PatchId(patch), side});
    sum += area(face_surface(model.patch(face.patch), face.side));
  }
  return sum;
}

std::vector<std::pair<PatchFace, PatchFace>> sorted(std::vector<std::pair<PatchFace, PatchFace>> pairs) {
  for (auto& [a, b] : pairs)
    if (b < a) std::swap(a, b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(Interfaces, OfTerrificAreItsList) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  PatchSet set = reference_patches("terrific/terrific.xml");
  const auto listed = sorted(set.listed_interfaces);
  ASSERT_EQ(listed.size(), 24u);
  set.listed_interfaces.clear();
  const MultiPatch model = connect(set);
  std::vector<std::pair<PatchFace, PatchFace>> found;
  for (const Interface& i : model.interfaces())
    found.emplace_back(model.renamed(i.first), model.renamed(i.second));
  EXPECT_EQ(sorted(found), listed);
  EXPECT_EQ(model.boundary_faces().size(), 42u);
  EXPECT_EQ(model.bodies().size(), 1u);
  // Reference values of six digits.
  EXPECT_NEAR(volume_of(model), 4.65324e-4, 0.5e-9);
  EXPECT_NEAR(area_of(model, {{0, Side::back}, {1, Side::back}, {2, Side::south}}), 2.2521e-3, 0.5e-7);
  EXPECT_NEAR(area_of(model, {{13, Side::front}, {14, Side::north}}), 2.25115e-3, 0.5e-8);
}

TEST(Interfaces, OfTheChairStandAreFoundWithoutAList) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const MultiPatch model = connect(reference_patches("chair_stand/chair_stand.xml"));
  EXPECT_EQ(model.interfaces().size(), 10u);
  EXPECT_EQ(model.boundary_faces().size(), 9u * 6 - 20);
  EXPECT_EQ(model.bodies().size(), 1u);
  for (int p = 0; p < model.patch_count(); ++p) EXPECT_TRUE(model.was_reversed(PatchId(p)));
  EXPECT_GT(volume_of(model), 0);
}

TEST(Interfaces, OfLooselyFittedPatchesNeedTheirTolerance) {
  for (const std::string name : {"terrific/terrificPart01_vol.xml", "terrific/terrificPart02_vol.xml"}) {
    ISOPATCH_NEEDS_DATA(name);
    const PatchSet set = reference_patches(name);
    try {
      connect(set);
      ADD_FAILURE() << name << " fits only to 5e-6 of its size and must be refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::not_conforming);
      EXPECT_THAT(error.what(), ::testing::HasSubstr("raise tolerance.same_point above 4.9e-06"));
    }
    const MultiPatch model = connect(set, {.same_point = 1e-5});
    EXPECT_EQ(model.interfaces().size(), 24u);
    EXPECT_EQ(model.boundary_faces().size(), 42u);
    EXPECT_EQ(model.bodies().size(), 1u);
  }
}

}  // namespace
}  // namespace isopatch::verification
