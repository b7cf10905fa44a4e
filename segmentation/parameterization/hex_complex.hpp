#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/face_map.hpp"
#include "segmentation/parameterization/hex_solid.hpp"

namespace isopatch::segmentation {

using geometry::FaceOrientation;

/// A side of a block.
struct BlockSide {
  int block = 0;
  Side side = Side::west;
  auto operator<=>(const BlockSide&) const = default;
};

/// An edge of a block, seen from the complex' edge that it is.
struct EdgeUse {
  int block = 0;
  int edge = 0;           ///< of the cube
  bool reversed = false;  ///< runs against the complex' edge
};

/// An edge of the complex: those of all blocks around it.
struct ComplexEdge {
  std::vector<EdgeUse> uses;
  std::array<int, 2> vertices{};  ///< start, end
  int sheet = 0;  ///< edges across a face from each other belong to one sheet and have common knots
  bool against_sheet = false;  ///< whether it runs against its sheet's direction
  /// Knots over [0, 1], in its direction, with which its curve and the faces at it are exact.
  std::vector<geometry::KnotVector> knots = {};
  bool surfaces_meet = true;  ///< whether the surfaces around it meet along it, whatever their outlines do
};

/// A side of a block, seen from the complex' face that it is.
struct FaceUse {
  BlockSide side;
  FaceOrientation orientation;  ///< from the face's frame to the side's
};

/// A face of the complex: one side, or the common sides of two blocks. Its frame is that of its first use.
struct ComplexFace {
  std::vector<FaceUse> uses;
  double gap = 0;  ///< largest distance between the two blocks' surfaces, as far as looked for; model units
};

/// A side that lies in another one without being all of it: a T-joint.
struct PartialContact {
  BlockSide part;
  BlockSide whole;
};

/// Directions of blocks that have common knots.
struct Sheet {
  bool symmetric = false;  ///< it meets itself turned around, so its knots must be symmetric
};

/// Topological hexahedra and how they meet.
struct HexComplex {
  std::vector<Hexahedron> blocks;
  std::vector<Eigen::Vector3d> vertices;  ///< on all surfaces around, model units
  std::vector<ComplexEdge> edges;
  std::vector<ComplexFace> faces;
  std::vector<Sheet> sheets;
  std::vector<PartialContact> partial_contacts;
  double size = 0;  ///< diagonal of the box of all corners and faces' middles, model units

  // Of each block, by corner, edge and side of the cube.
  std::vector<std::array<int, 8>> block_vertices;
  std::vector<std::array<int, 12>> block_edges;
  std::vector<std::array<int, 6>> block_faces;
  std::vector<std::array<FaceMap, 6>> maps;

  const FaceMap& map(BlockSide side) const {
    return maps[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.side)];
  }
  /// "block:face", by their names.
  std::string label(BlockSide side) const;
};

/// "block:face" of a side.
std::string label_of(const std::vector<Hexahedron>& blocks, BlockSide side);

}  // namespace isopatch::segmentation
