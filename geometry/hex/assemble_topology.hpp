#pragma once

#include <vector>

#include "geometry/hex/hex_topology.hpp"

namespace isopatch::geometry {

/// Two sides that are one face.
struct SideMatch {
  BlockSide first, second;
  FaceOrientation orientation;  ///< from first to second
  double gap = 0;               ///< as in `HexFace`
};

/// Two corners that are one vertex.
struct CornerMatch {
  BlockCorner first, second;
};

/// Two edges that are one.
struct EdgeMatch {
  BlockEdge first, second;
  bool against = false;  ///< run through in opposite directions
};

/// What is known of how blocks meet.
struct HexContacts {
  std::vector<SideMatch> sides;
  std::vector<CornerMatch> corners = {};  ///< that no common side joins
  std::vector<EdgeMatch> edges = {};      ///< likewise; their ends are joined, too
};

/// Numbers vertices, edges, faces and sheets as the blocks meet them, in their order.
/// @throws Error invalid_argument  a block or a side that does not exist, a side in two pairs
/// @cost   O(blocks)
HexTopology assembled_topology(int blocks, const HexContacts& contacts);

}  // namespace isopatch::geometry
