#include "segmentation/parameterization/internal/hex_complex.hpp"

#include <Eigen/Geometry>

#include "segmentation/parameterization/internal/best_face_map.hpp"
#include "segmentation/parameterization/internal/outline.hpp"

namespace isopatch::segmentation {

std::vector<Hexahedron> hexahedra(const HexModel& model) {
  std::vector<Hexahedron> blocks;
  for (std::size_t b = 0; b < model.solids.size(); ++b) {
    std::array<FaceId, 6> sides;
    for (std::size_t side = 0; side < 6; ++side) sides[side] = model.faces[b][side].face;
    blocks.push_back(hexahedron(model.solids[b], sides));
  }
  return blocks;
}

std::vector<std::array<FaceMap, 6>> face_maps(const std::vector<Hexahedron>& blocks) {
  std::vector<std::array<FaceMap, 6>> result;
  for (const Hexahedron& block : blocks) {
    const auto map = [&](std::size_t side) { return best_face_map(block.faces[side]); };
    result.push_back({map(0), map(1), map(2), map(3), map(4), map(5)});
  }
  return result;
}

double size_of(const std::vector<Hexahedron>& blocks) {
  Eigen::AlignedBox3d box;
  for (const Hexahedron& block : blocks) {
    for (const auto& corner : block.corners) box.extend(corner);
    for (const QuadFace& face : block.faces) box.extend(face.surface(coons_point(face.sides, 0.5, 0.5)));
  }
  return box.diagonal().norm();
}

}  // namespace isopatch::segmentation
