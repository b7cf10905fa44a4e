#include "geometry/hex/assemble_topology.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::geometry {
namespace {

BlockSide side(int block, Side which) {
  return {BlockId(block), which};
}

/// Blocks in a ring, east on west; the last one meets the first one in an orientation of its own.
HexTopology ring(int blocks, const FaceOrientation& last) {
  HexContacts contacts;
  for (int b = 0; b < blocks; ++b)
    contacts.sides.push_back({side(b, Side::east), side((b + 1) % blocks, Side::west),
                              b + 1 == blocks ? last : FaceOrientation{}});
  return assembled_topology(blocks, contacts);
}

TEST(HexTopology, TwoBlocksShareAFaceHoweverItIsTurned) {
  for (const Side first : all_sides)
    for (const Side second : all_sides)
      for (int i = 0; i < 8; ++i) {
        const FaceOrientation orientation{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
        const HexTopology topology =
            assembled_topology(2, {{{side(0, first), side(1, second), orientation, 0.25}}});
        EXPECT_EQ(topology.vertex_count, 12);
        EXPECT_EQ(topology.edges.size(), 20u);
        EXPECT_EQ(topology.faces.size(), 11u);
        EXPECT_EQ(topology.sheets.size(), 4u);
        validate(topology);
        const HexFace& common = topology.face(topology.at(side(0, first)));
        EXPECT_EQ(topology.at(side(1, second)), topology.at(side(0, first)));
        ASSERT_EQ(common.uses.size(), 2u);
        EXPECT_EQ(common.uses[1].orientation, orientation);
        EXPECT_EQ(common.gap, 0.25);
      }
}

TEST(HexTopology, ARingHasOneSheetForEachBlockAndTwoThatGoAround) {
  const HexTopology topology = ring(5, {});
  EXPECT_EQ(topology.vertex_count, 20);
  EXPECT_EQ(topology.edges.size(), 40u);
  EXPECT_EQ(topology.faces.size(), 25u);
  ASSERT_EQ(topology.sheets.size(), 7u);
  for (const Sheet& sheet : topology.sheets) EXPECT_FALSE(sheet.symmetric);
  // The edges of a sheet run the same way around.
  for (const HexEdge& edge : topology.edges) EXPECT_FALSE(edge.against_sheet);
}

TEST(HexTopology, ASheetThatMeetsItselfTurnedAroundIsSymmetric) {
  const HexTopology half_turn = ring(4, {.flip_first = true, .flip_second = true});
  int symmetric = 0;
  for (const Sheet& sheet : half_turn.sheets) symmetric += sheet.symmetric;
  EXPECT_EQ(symmetric, 2);
  // A quarter turn makes one sheet of both directions across.
  const HexTopology quarter_turn = ring(4, {.swapped = true, .flip_first = true});
  EXPECT_EQ(quarter_turn.sheets.size(), half_turn.sheets.size() - 1);
  validate(quarter_turn);
}

TEST(HexTopology, EdgesMayBeOneWithoutACommonSide) {
  const HexTopology topology = assembled_topology(
      2, {.sides = {}, .corners = {}, .edges = {{{BlockId(0), 3}, {BlockId(1), 4}, true}}});
  EXPECT_EQ(topology.vertex_count, 14);
  EXPECT_EQ(topology.edges.size(), 23u);
  validate(topology);
  const HexEdge& common = topology.edge(topology.at(BlockEdge{BlockId(1), 4}));
  ASSERT_EQ(common.uses.size(), 2u);
  EXPECT_TRUE(common.uses[1].reversed);
}

TEST(HexTopology, WrongPairsAreRefused) {
  const auto message = [](const HexContacts& contacts) -> std::string {
    try {
      assembled_topology(2, contacts);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message({{{side(0, Side::east), side(2, Side::west), {}}}}), testing::HasSubstr("block 2"));
  EXPECT_THAT(message({{{side(0, Side::east), side(1, Side::west), {}},
                        {side(1, Side::west), side(0, Side::back), {}}}}),
              testing::HasSubstr("side west of block 1 is in two pairs"));
}

TEST(HexTopology, WhatContradictsItselfIsFound) {
  const HexTopology sound = ring(3, {});
  validate(sound);
  HexTopology broken = sound;
  std::swap(broken.edges[0].vertices[0], broken.edges[0].vertices[1]);
  EXPECT_ERROR(validate(broken), ErrorCode::invalid_argument, "contradicts itself");
  broken = sound;
  broken.blocks[1].faces[2] = HexFaceId(99);
  EXPECT_ERROR(validate(broken), ErrorCode::invalid_argument, "contradicts itself");
  broken = sound;
  broken.faces[0].uses.push_back(broken.faces[0].uses[0]);
  EXPECT_ERROR(validate(broken), ErrorCode::invalid_argument, "contradicts itself");
  broken = sound;
  broken.t_joints.push_back({side(3, Side::west), {}});
  EXPECT_ERROR(validate(broken), ErrorCode::invalid_argument, "contradicts itself");
  broken = sound;
  broken.edges[4].sheet = SheetId(-1);
  EXPECT_ERROR(validate(broken), ErrorCode::invalid_argument, "contradicts itself");
}

}  // namespace
}  // namespace isopatch::geometry
