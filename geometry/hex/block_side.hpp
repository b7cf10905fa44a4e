#pragma once

#include <compare>

#include "geometry/hex/hex_ids.hpp"
#include "geometry/patch_face.hpp"

namespace isopatch::geometry {

/// A side of a block. Its frame (s, t) runs along its two tangent directions, each from 0 to 1.
struct BlockSide {
  BlockId block;
  Side side = Side::west;
  auto operator<=>(const BlockSide&) const = default;
};

/// An edge of a block, as `cube.hpp` numbers them.
struct BlockEdge {
  BlockId block;
  int edge = 0;
  auto operator<=>(const BlockEdge&) const = default;
};

/// A corner of a block, as `cube.hpp` numbers them.
struct BlockCorner {
  BlockId block;
  int corner = 0;
  auto operator<=>(const BlockCorner&) const = default;
};

}  // namespace isopatch::geometry
