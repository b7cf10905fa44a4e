#include "segmentation/parameterization/internal/hex_complex.hpp"

#include <Eigen/Geometry>

#include "segmentation/parameterization/internal/edge_pace.hpp"
#include "segmentation/parameterization/internal/edge_samples.hpp"
#include "segmentation/parameterization/internal/outline.hpp"

namespace isopatch::segmentation {
namespace {

/// The mean of the blocks' corners at each vertex.
std::vector<Eigen::Vector3d> mean_corners(const HexComplex& complex) {
  const auto count = static_cast<std::size_t>(complex.topology.vertex_count);
  std::vector<Eigen::Vector3d> sums(count, Eigen::Vector3d::Zero());
  std::vector<int> uses(count, 0);
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (std::size_t c = 0; c < 8; ++c) {
      const auto v = static_cast<std::size_t>(complex.topology.blocks[b].vertices[c].value);
      sums[v] += complex.blocks[b].corners[c];
      ++uses[v];
    }
  for (std::size_t v = 0; v < count; ++v) sums[v] /= uses[v];
  return sums;
}

}  // namespace

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
    const auto map = [&](std::size_t side) { return face_map(block.faces[side]); };
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

HexComplex hex_complex(const HexModel& model) {
  HexComplex complex;
  complex.topology = model.topology;
  complex.blocks = hexahedra(model);
  complex.maps = face_maps(complex.blocks);
  complex.size = size_of(complex.blocks);
  complex.vertices = mean_corners(complex);
  complex.edges.resize(model.topology.edges.size());
  settle_paces(complex);
  settle_edges(complex);
  return complex;
}

}  // namespace isopatch::segmentation
