#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/hex/block_side.hpp"

namespace isopatch::geometry {

/// s in [low[0], high[0]], t in [low[1], high[1]] of a side's frame.
struct SideRectangle {
  std::array<double, 2> low{}, high{};
  bool operator==(const SideRectangle&) const = default;
};

/// What lies in a side without being all of it.
struct SidePart {
  BlockSide side;
  /// Which piece of that side, in its own frame; all of it where there is nothing.
  std::optional<SideRectangle> piece = {};
  /// Its outline in the frame of the side that it lies in: a closed polygon, counterclockwise.
  std::vector<std::array<double, 2>> outline = {};
  /// The outline where that is a rectangle along s and t.
  std::optional<SideRectangle> rectangle = {};
  bool operator==(const SidePart&) const = default;
};

/// A side that meets others in parts. Along edges parameters are shares of arc length, inside they are
/// blended.
struct TJoint {
  BlockSide whole;
  std::vector<SidePart> parts;
  bool operator==(const TJoint&) const = default;
};

/// A vertex within an edge that does not end there.
struct EdgeSplit {
  HexVertexId vertex;
  double share = 0;  ///< of the edge's length behind it, from its start; in (0, 1)
  bool operator==(const EdgeSplit&) const = default;
};

/// An edge that ends of others divide.
struct SplitEdge {
  HexEdgeId edge;
  std::vector<EdgeSplit> at;  ///< shares increasing
  bool operator==(const SplitEdge&) const = default;
};

}  // namespace isopatch::geometry
