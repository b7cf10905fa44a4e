#include "geometry/patch_connections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/transfer.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using testing::HasSubstr;

// Eight boxes, the second and the fifth left-handed in the file, with a named boundary on each.
MultiPatch model() {
  PatchSet set{test::eight_boxes(), {}, {}};
  for (const std::size_t p : {1u, 4u}) set.patches[p] = reversed(set.patches[p], 0);
  set.boundaries = {{"end", {{PatchId(1), Side::west}, {PatchId(3), Side::east}}}};
  return connect(std::move(set));
}

void expect_same(const MultiPatch& found, const MultiPatch& expected) {
  EXPECT_EQ(found.boundary_faces(), expected.boundary_faces());
  EXPECT_EQ(found.degenerate_faces(), expected.degenerate_faces());
  ASSERT_EQ(found.interfaces().size(), expected.interfaces().size());
  for (std::size_t i = 0; i < found.interfaces().size(); ++i) {
    EXPECT_EQ(found.interfaces()[i].first, expected.interfaces()[i].first);
    EXPECT_EQ(found.interfaces()[i].second, expected.interfaces()[i].second);
    EXPECT_EQ(found.interfaces()[i].orientation, expected.interfaces()[i].orientation);
  }
  ASSERT_EQ(found.boundaries().size(), expected.boundaries().size());
  for (std::size_t b = 0; b < found.boundaries().size(); ++b) {
    EXPECT_EQ(found.boundaries()[b].name, expected.boundaries()[b].name);
    EXPECT_EQ(found.boundaries()[b].faces, expected.boundaries()[b].faces);
  }
  for (int p = 0; p < expected.patch_count(); ++p) {
    EXPECT_EQ(found.was_reversed(PatchId(p)), expected.was_reversed(PatchId(p)));
    for (const Side side : all_sides)
      EXPECT_EQ(found.label({PatchId(p), side}), expected.label({PatchId(p), side}));
  }
}

TEST(PatchConnections, MakeTheSameModelAgain) {
  const MultiPatch expected = model();
  EXPECT_TRUE(expected.was_reversed(PatchId(1)));
  EXPECT_EQ(expected.label(expected.boundaries()[0].faces[0]), "1:west");
  expect_same(connected(expected.patches(), connections_of(expected)), expected);
}

TEST(PatchConnections, HoldForRefinedPatches) {
  const MultiPatch expected = model();
  std::vector<NurbsVolume> finer;
  for (const NurbsVolume& patch : expected.patches()) {
    auto knots = patch.knots();
    for (KnotVector& k : knots) k = with_knots(with_degree_raised(k, 1), {0.5 * (k.first() + k.last())});
    finer.push_back(refined(patch, knots));
  }
  expect_same(connected(finer, connections_of(expected)), expected);
}

TEST(PatchConnections, KeepAGapThatWasAccepted) {
  PatchSet set{
      {test::box_between({0, 0, 0}, {1, 1, 1}), test::box_between({1.0005, 0, 0}, {2, 1, 1})}, {}, {}};
  const MultiPatch expected = connect(set, {.same_point = 1e-3, .near_miss = 2e-3});
  ASSERT_EQ(expected.interfaces().size(), 1u);
  expect_same(connected(expected.patches(), connections_of(expected)), expected);
}

// Faces that agree point by point, but may have other functions on both sides.
TEST(PatchConnections, KeepApartWhatWasKeptApart) {
  PatchSet set{test::eight_boxes(), {}, {}};
  const MultiPatch whole = connect(std::move(set), {.keep_non_matching = true});
  std::vector<bool> apart(whole.interfaces().size(), false);
  apart[2] = apart[5] = true;
  const MultiPatch expected = whole.with_apart(apart);
  EXPECT_EQ(expected.interfaces().size(), whole.interfaces().size() - 2);
  EXPECT_EQ(expected.non_matching().size(), 2u);
  EXPECT_EQ(expected.bodies().size(), 1u);
  const MultiPatch found = connected(expected.patches(), connections_of(expected));
  expect_same(found, expected);
  EXPECT_EQ(found.non_matching(), expected.non_matching());
}

TEST(PatchConnections, ThatCannotBeAreRefused) {
  const MultiPatch good = model();
  const auto refused = [&](auto change) -> std::string {
    PatchConnections connections = connections_of(good);
    change(connections);
    try {
      connected(good.patches(), connections);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(refused([](PatchConnections&) {}), "no error");
  EXPECT_THAT(refused([](PatchConnections& c) { c.reversed.pop_back(); }),
              HasSubstr("7 patches are given for 8"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.interfaces[0].first.patch = PatchId(8); }),
              HasSubstr("no face 1 of patch 8"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.interfaces[0].first.side = static_cast<Side>(-1); }),
              HasSubstr("no face -1 of patch"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.boundaries[0].faces[0].patch = PatchId(-1); }),
              HasSubstr("of patch -1"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.interfaces.push_back(c.interfaces[0]); }),
              HasSubstr("is joined twice"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.interfaces.pop_back(); }), HasSubstr("do not meet as"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.interfaces[0].orientation.flip_first ^= true; }),
              HasSubstr("do not meet as"));
  EXPECT_THAT(refused([](PatchConnections& c) { c.size = 0; }), HasSubstr("size is 0"));
}

}  // namespace
}  // namespace isopatch::geometry
