#pragma once

#include "geometry/base/ids.hpp"

namespace isopatch::geometry {

// Of a complex of hexahedra.
using BlockId = Id<struct BlockTag>;
using HexVertexId = Id<struct HexVertexTag>;
using HexEdgeId = Id<struct HexEdgeTag>;
using HexFaceId = Id<struct HexFaceTag>;
using SheetId = Id<struct SheetTag>;

}  // namespace isopatch::geometry
