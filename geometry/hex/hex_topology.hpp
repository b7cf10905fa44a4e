#pragma once

#include <array>
#include <vector>

#include "geometry/hex/block_side.hpp"
#include "geometry/hex/t_joint.hpp"
#include "geometry/interface.hpp"

namespace isopatch::geometry {

/// An edge of a block, seen from the complex' edge that it is.
struct HexEdgeUse {
  BlockEdge edge;
  bool reversed = false;  ///< runs against the complex' edge
  bool operator==(const HexEdgeUse&) const = default;
};

/// An edge of the complex: those of all blocks around it.
struct HexEdge {
  std::vector<HexEdgeUse> uses;         ///< by block
  std::array<HexVertexId, 2> vertices;  ///< start, end
  SheetId sheet;               ///< edges across a face from each other belong to one sheet: common knots
  bool against_sheet = false;  ///< whether it runs against its sheet's direction
  bool operator==(const HexEdge&) const = default;
};

/// A side of a block, seen from the complex' face that it is.
struct HexFaceUse {
  BlockSide side;
  FaceOrientation orientation;  ///< from the face's frame to the side's
  bool operator==(const HexFaceUse&) const = default;
};

/// A face of the complex: one side, or the common sides of two blocks. Its frame is that of its first use.
struct HexFace {
  std::vector<HexFaceUse> uses;
  double gap = 0;  ///< largest distance found between the two blocks' surfaces, model units
  bool operator==(const HexFace&) const = default;
};

/// Directions of blocks that have common knots.
struct Sheet {
  bool symmetric = false;  ///< it meets itself turned around, so its knots must be symmetric
  bool operator==(const Sheet&) const = default;
};

/// What a block consists of, by corner, edge and side of the cube.
struct HexBlock {
  std::array<HexVertexId, 8> vertices;
  std::array<HexEdgeId, 12> edges;
  std::array<HexFaceId, 6> faces;
  bool operator==(const HexBlock&) const = default;
};

/// Topological hexahedra and how they meet: plain data without geometry.
struct HexTopology {
  int vertex_count = 0;
  std::vector<HexEdge> edges;
  std::vector<HexFace> faces;
  std::vector<HexBlock> blocks;
  std::vector<Sheet> sheets;
  std::vector<TJoint> t_joints;        ///< where sides meet in parts; none in a conforming complex
  std::vector<SplitEdge> split_edges;  ///< likewise

  const HexEdge& edge(HexEdgeId id) const { return edges[static_cast<std::size_t>(id.value)]; }
  const HexFace& face(HexFaceId id) const { return faces[static_cast<std::size_t>(id.value)]; }
  const HexBlock& block(BlockId id) const { return blocks[static_cast<std::size_t>(id.value)]; }
  HexVertexId at(BlockCorner corner) const {
    return block(corner.block).vertices[static_cast<std::size_t>(corner.corner)];
  }
  HexEdgeId at(BlockEdge edge) const { return block(edge.block).edges[static_cast<std::size_t>(edge.edge)]; }
  HexFaceId at(BlockSide side) const { return block(side.block).faces[static_cast<std::size_t>(side.side)]; }

  bool operator==(const HexTopology&) const = default;
};

/// Whether a block runs through an edge against the complex' direction.
bool is_reversed(const HexTopology& topology, BlockEdge edge);

/// Holds uses, blocks and sheets against each other.
/// @throws Error invalid_argument  what does not exist, or is said in two ways
void validate(const HexTopology& topology);

}  // namespace isopatch::geometry
