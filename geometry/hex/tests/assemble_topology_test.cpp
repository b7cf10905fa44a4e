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

struct TopologyBreach {
  const char* words;
  void (*make)(HexTopology& topology);
};

TEST(HexTopology, WhatContradictsItselfIsFound) {
  const HexTopology sound = ring(3, {});
  validate(sound);
  const TopologyBreach breaches[] = {
      {"of block 1, a vertex is 12; there are 12",
       [](HexTopology& t) { t.blocks[1].vertices[5] = HexVertexId(12); }},
      {"of block 2, an edge is -1", [](HexTopology& t) { t.blocks[2].edges[11] = HexEdgeId(-1); }},
      {"of block 1, a face is 99; there are 15",
       [](HexTopology& t) { t.blocks[1].faces[2] = HexFaceId(99); }},
      {"edge 4's sheet is -1; there are 5", [](HexTopology& t) { t.edges[4].sheet = SheetId(-1); }},
      {"edge 4's block is 3; there are 3",
       [](HexTopology& t) { t.edges[4].uses[0].edge.block = BlockId(3); }},
      {"an edge of edge 4's block is 12; a cube has 12",
       [](HexTopology& t) { t.edges[4].uses[0].edge.edge = 12; }},
      {"block 0 does not know edge 1", [](HexTopology& t) { t.edges[1].uses[0] = t.edges[0].uses[0]; }},
      {"edge 0 ends elsewhere in block 0",
       [](HexTopology& t) { std::swap(t.edges[0].vertices[0], t.edges[0].vertices[1]); }},
      {"a block's edge is none of the complex", [](HexTopology& t) { t.edges[3].uses.pop_back(); }},
      {"face 0 lies between 3 blocks", [](HexTopology& t) { t.faces[0].uses.push_back(t.faces[0].uses[0]); }},
      {"face 3 lies between 0 blocks", [](HexTopology& t) { t.faces[3].uses.clear(); }},
      {"block 0 does not know face 1", [](HexTopology& t) { t.faces[1].uses[0] = t.faces[2].uses[0]; }},
      {"face 1's side is 6; a cube has 6",
       [](HexTopology& t) { t.faces[1].uses[0].side.side = static_cast<Side>(6); }},
      {"a block's side is none of the complex",
       [](HexTopology& t) {
         for (HexFace& face : t.faces)
           if (face.uses.size() == 2) face.uses.pop_back();
       }},
      {"a T-joint's block is 3; there are 3",
       [](HexTopology& t) {
         t.t_joints.push_back({side(3, Side::west), {}});
       }},
      {"a part of a T-joint's block is -1",
       [](HexTopology& t) {
         t.t_joints.push_back({side(0, Side::west), {{side(-1, Side::west)}}});
       }},
      {"a split edge is 24; there are 24",
       [](HexTopology& t) {
         t.split_edges.push_back({HexEdgeId(24), {}});
       }},
      {"a split edge's vertex is 12", [](HexTopology& t) {
         t.split_edges.push_back({HexEdgeId(0), {{HexVertexId(12), 0.5}}});
       }}};
  for (const auto& [words, make] : breaches) {
    HexTopology broken = sound;
    make(broken);
    EXPECT_ERROR(validate(broken), ErrorCode::invalid_argument, std::string("contradicts itself: ") + words);
  }
}

}  // namespace
}  // namespace isopatch::geometry
