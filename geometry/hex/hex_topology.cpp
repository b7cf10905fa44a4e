#include "geometry/hex/hex_topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "geometry/base/error.hpp"
#include "geometry/hex/cube.hpp"

namespace isopatch::geometry {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::invalid_argument, "a complex of hexahedra contradicts itself: " + what);
}

template <class Tag>
void require(Id<Tag> id, std::size_t count, const std::string& what) {
  if (id.value < 0 || static_cast<std::size_t>(id.value) >= count)
    refuse(fmt::format("{} is {}; there are {}", what, id.value, count));
}

void require_number(int number, int count, const std::string& what) {
  if (number < 0 || number >= count) refuse(fmt::format("{} is {}; a cube has {}", what, number, count));
}

void require_side(const HexTopology& topology, BlockSide side, const std::string& what) {
  require(side.block, topology.blocks.size(), what + "'s block");
  require_number(static_cast<int>(side.side), 6, what + "'s side");
}

void check_blocks(const HexTopology& topology) {
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const std::string block = fmt::format("of block {}, ", b);
    for (const HexVertexId id : topology.blocks[b].vertices)
      require(id, static_cast<std::size_t>(std::max(topology.vertex_count, 0)), block + "a vertex");
    for (const HexEdgeId id : topology.blocks[b].edges) require(id, topology.edges.size(), block + "an edge");
    for (const HexFaceId id : topology.blocks[b].faces) require(id, topology.faces.size(), block + "a face");
  }
}

void check_edges(const HexTopology& topology) {
  std::size_t uses = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const HexEdge& edge = topology.edges[e];
    const HexEdgeId id(static_cast<int>(e));
    require(edge.sheet, topology.sheets.size(), fmt::format("edge {}'s sheet", e));
    for (const HexEdgeUse& use : edge.uses) {
      require(use.edge.block, topology.blocks.size(), fmt::format("edge {}'s block", e));
      require_number(use.edge.edge, 12, fmt::format("an edge of edge {}'s block", e));
      if (topology.at(use.edge) != id)
        refuse(fmt::format("block {} does not know edge {}", use.edge.block.value, e));
      const auto ends = edge_corners(use.edge.edge);
      for (std::size_t end = 0; end < 2; ++end)
        if (topology.at(BlockCorner{use.edge.block, ends[use.reversed ? 1 - end : end]}) !=
            edge.vertices[end])
          refuse(fmt::format("edge {} ends elsewhere in block {}", e, use.edge.block.value));
    }
    uses += edge.uses.size();
  }
  if (uses != 12 * topology.blocks.size()) refuse("a block's edge is none of the complex");
}

void check_faces(const HexTopology& topology) {
  std::size_t uses = 0;
  for (std::size_t f = 0; f < topology.faces.size(); ++f) {
    const HexFace& face = topology.faces[f];
    if (face.uses.empty() || face.uses.size() > 2)
      refuse(fmt::format("face {} lies between {} blocks", f, face.uses.size()));
    for (const HexFaceUse& use : face.uses) {
      require_side(topology, use.side, fmt::format("face {}", f));
      if (topology.at(use.side) != HexFaceId(static_cast<int>(f)))
        refuse(fmt::format("block {} does not know face {}", use.side.block.value, f));
    }
    uses += face.uses.size();
  }
  if (uses != 6 * topology.blocks.size()) refuse("a block's side is none of the complex");
}

void check_t_joints(const HexTopology& topology) {
  for (const TJoint& joint : topology.t_joints) {
    require_side(topology, joint.whole, "a T-joint");
    for (const SidePart& part : joint.parts) require_side(topology, part.side, "a part of a T-joint");
  }
  for (const SplitEdge& split : topology.split_edges) {
    require(split.edge, topology.edges.size(), "a split edge");
    for (const EdgeSplit& at : split.at)
      require(at.vertex, static_cast<std::size_t>(std::max(topology.vertex_count, 0)),
              "a split edge's vertex");
  }
}

}  // namespace

bool is_reversed(const HexTopology& topology, BlockEdge edge) {
  const auto& uses = topology.edge(topology.at(edge)).uses;
  const auto found =
      std::find_if(uses.begin(), uses.end(), [&](const HexEdgeUse& use) { return use.edge == edge; });
  if (found == uses.end()) throw Error(ErrorCode::internal, "an edge of a complex does not know its block");
  return found->reversed;
}

void validate(const HexTopology& topology) {
  check_blocks(topology);
  check_edges(topology);
  check_faces(topology);
  check_t_joints(topology);
}

}  // namespace isopatch::geometry
