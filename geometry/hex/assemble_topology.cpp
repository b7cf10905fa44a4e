#include "geometry/hex/assemble_topology.hpp"

#include <fmt/format.h>

#include <map>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/hex/cube.hpp"

namespace isopatch::geometry {
namespace {

/// Number of a corner or an edge among those of all blocks.
int number_of(BlockCorner corner) {
  return 8 * corner.block.value + corner.corner;
}
int number_of(BlockEdge edge) {
  return 12 * edge.block.value + edge.edge;
}

void check(int blocks, const HexContacts& contacts) {
  std::map<BlockSide, int> pairs;
  for (const SideMatch& match : contacts.sides)
    for (const BlockSide side : {match.first, match.second}) {
      if (side.block.value < 0 || side.block.value >= blocks)
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("two sides are said to meet, one of block {}; there are {}", side.block.value,
                                blocks));
      if (++pairs[side] > 1)
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("side {} of block {} is in two pairs", name(side.side), side.block.value));
    }
}

/// Corners and edges of all blocks, those together that are one.
struct Joined {
  UnionFind corners;
  SignedUnionFind edges;

  void join(const SideMatch& match) {
    for (int s = 0; s < 2; ++s)
      for (int t = 0; t < 2; ++t) {
        const Parameter<2> other = match.orientation(Parameter<2>(s, t));
        const int there =
            side_corner(match.second.side, static_cast<int>(other[0]), static_cast<int>(other[1]));
        join(CornerMatch{{match.first.block, side_corner(match.first.side, s, t)},
                         {match.second.block, there}});
      }
    const FaceOrientation& o = match.orientation;
    const auto own = side_edges(match.first.side), others = side_edges(match.second.side);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool along_first = k < 2, high = k % 2 == 1;
      // Where this side of the square, and a direction along it, go on the other face.
      const bool lands_first = along_first != o.swapped;
      const bool turned = lands_first ? o.flip_first : o.flip_second;
      const bool end = high != (lands_first ? o.flip_second : o.flip_first);
      const int there = others[(lands_first ? 0u : 2u) + (end ? 1u : 0u)];
      edges.unite(number_of(BlockEdge{match.first.block, own[k]}),
                  number_of(BlockEdge{match.second.block, there}), turned);
    }
  }
  void join(const CornerMatch& match) { corners.unite(number_of(match.first), number_of(match.second)); }
  void join(const EdgeMatch& match) {
    edges.unite(number_of(match.first), number_of(match.second), match.against);
    const auto own = edge_corners(match.first.edge), others = edge_corners(match.second.edge);
    for (std::size_t end = 0; end < 2; ++end)
      join(CornerMatch{{match.first.block, own[end]},
                       {match.second.block, others[match.against ? 1 - end : end]}});
  }
};

void number_vertices(HexTopology& topology, UnionFind& corners) {
  std::map<int, HexVertexId> numbers;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    for (int c = 0; c < 8; ++c) {
      const int first = corners.find(number_of(BlockCorner{BlockId(static_cast<int>(b)), c}));
      const auto [found, fresh] = numbers.try_emplace(first, HexVertexId(topology.vertex_count));
      topology.vertex_count += fresh;
      topology.blocks[b].vertices[static_cast<std::size_t>(c)] = found->second;
    }
}

void number_edges(HexTopology& topology, SignedUnionFind& edges) {
  std::map<int, HexEdgeId> numbers;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    for (int e = 0; e < 12; ++e) {
      const BlockEdge here{BlockId(static_cast<int>(b)), e};
      const SignedUnionFind::Member first = edges.find(number_of(here));
      const auto [found, fresh] =
          numbers.try_emplace(first.root, HexEdgeId(static_cast<int>(topology.edges.size())));
      if (fresh) topology.edges.emplace_back();
      HexEdge& edge = topology.edges[static_cast<std::size_t>(found->second.value)];
      edge.uses.push_back({here, first.against});
      const auto ends = edge_corners(e);
      const auto& at = topology.blocks[b].vertices;
      edge.vertices = {at[static_cast<std::size_t>(ends[first.against ? 1 : 0])],
                       at[static_cast<std::size_t>(ends[first.against ? 0 : 1])]};
      topology.blocks[b].edges[static_cast<std::size_t>(e)] = found->second;
    }
}

void number_faces(HexTopology& topology, const std::vector<SideMatch>& matches) {
  std::map<BlockSide, const SideMatch*> first_of, second_of;
  for (const SideMatch& match : matches) {
    first_of[match.first] = &match;
    second_of[match.second] = &match;
  }
  const auto number = [&](BlockSide side) -> HexFaceId& {
    return topology.blocks[static_cast<std::size_t>(side.block.value)]
        .faces[static_cast<std::size_t>(side.side)];
  };
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    for (const Side side : all_sides) {
      const BlockSide here{BlockId(static_cast<int>(b)), side};
      if (second_of.contains(here)) continue;
      HexFace face{{{here, {}}}, 0};
      number(here) = HexFaceId(static_cast<int>(topology.faces.size()));
      if (const auto found = first_of.find(here); found != first_of.end()) {
        face.uses.push_back({found->second->second, found->second->orientation});
        face.gap = found->second->gap;
        number(found->second->second) = number(here);
      }
      topology.faces.push_back(std::move(face));
    }
}

// The four parallel edges of each block's direction belong together; two ways around that disagree make a
// sheet symmetric.
void find_sheets(HexTopology& topology) {
  SignedUnionFind together(static_cast<int>(topology.edges.size()));
  std::vector<int> turned;  // edges of sheets that meet themselves turned around
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    for (int e = 0; e < 12; ++e) {
      const BlockId block(static_cast<int>(b));
      const BlockEdge first{block, 4 * edge_direction(e)}, here{block, e};
      const bool against = is_reversed(topology, first) != is_reversed(topology, here);
      if (!together.unite(topology.at(first).value, topology.at(here).value, against))
        turned.push_back(topology.at(here).value);
    }
  std::map<int, SheetId> numbers;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const SignedUnionFind::Member first = together.find(static_cast<int>(e));
    const auto [found, fresh] =
        numbers.try_emplace(first.root, SheetId(static_cast<int>(topology.sheets.size())));
    if (fresh) topology.sheets.emplace_back();
    topology.edges[e].sheet = found->second;
    topology.edges[e].against_sheet = first.against;
  }
  for (const int e : turned)
    topology.sheets[static_cast<std::size_t>(topology.edge(HexEdgeId(e)).sheet.value)].symmetric = true;
}

}  // namespace

HexTopology assembled_topology(int blocks, const HexContacts& contacts) {
  check(blocks, contacts);
  Joined joined{UnionFind(8 * blocks), SignedUnionFind(12 * blocks)};
  for (const SideMatch& match : contacts.sides) joined.join(match);
  for (const CornerMatch& match : contacts.corners) joined.join(match);
  for (const EdgeMatch& match : contacts.edges) joined.join(match);
  HexTopology topology;
  topology.blocks.resize(static_cast<std::size_t>(blocks));
  number_vertices(topology, joined.corners);
  number_edges(topology, joined.edges);
  number_faces(topology, contacts.sides);
  find_sheets(topology);
  return topology;
}

}  // namespace isopatch::geometry
