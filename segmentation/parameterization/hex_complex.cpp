#include "segmentation/parameterization/hex_complex.hpp"

namespace isopatch::segmentation {

std::string label_of(const std::vector<Hexahedron>& blocks, BlockSide side) {
  const Hexahedron& block = blocks[static_cast<std::size_t>(side.block)];
  return block.name + ":" + block.face(side.side).name;
}

std::string HexComplex::label(BlockSide side) const {
  return label_of(blocks, side);
}

}  // namespace isopatch::segmentation
