#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/base/ids.hpp"

namespace isopatch::geometry {

/// The face of a solid that a side of a block is.
struct BlockFace {
  int solid = 0;            ///< which of the solids that the blocks are made of, from 0
  FaceId face;              ///< of that solid
  std::string name;         ///< what users call it
  std::string colour = {};  ///< "#rrggbb"; "" where it has none
  bool operator==(const BlockFace&) const = default;
};

/// Of each block, by side.
using BlockFaces = std::vector<std::array<BlockFace, 6>>;

}  // namespace isopatch::geometry
