#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/hex/hex_topology.hpp"
#include "segmentation/parameterization/hex_model.hpp"
#include "segmentation/parameterization/internal/face_map.hpp"
#include "segmentation/parameterization/internal/hexahedron.hpp"

namespace isopatch::segmentation {

using geometry::BlockCorner;
using geometry::BlockEdge;
using geometry::BlockId;
using geometry::BlockSide;
using geometry::FaceOrientation;
using geometry::HexEdge;
using geometry::HexEdgeId;
using geometry::HexEdgeUse;
using geometry::HexFace;
using geometry::HexFaceId;
using geometry::HexFaceUse;
using geometry::HexTopology;

/// What is known of the shape of an edge.
struct EdgeShape {
  /// Knots over [0, 1], in its direction, with which its curve and the faces at it are exact.
  std::vector<geometry::KnotVector> knots = {};
  /// Its rational form, in its direction over [0, 1], where all around it agree on that.
  std::optional<geometry::NurbsCurve> exact = {};
  bool surfaces_meet = true;  ///< whether the surfaces around it meet along it, whatever their outlines do
};

/// A complex with its geometry, as the parameterization works on it.
struct HexComplex {
  HexTopology topology;
  std::vector<Hexahedron> blocks;
  std::vector<std::array<FaceMap, 6>> maps;  ///< by block and side
  std::vector<Eigen::Vector3d> vertices;     ///< on all surfaces around, m
  std::vector<EdgeShape> edges;
  double size = 0;  ///< diagonal of the box of all corners and faces' middles, m

  const Hexahedron& block(BlockId id) const { return blocks[static_cast<std::size_t>(id.value)]; }
  const FaceMap& map(BlockSide side) const {
    return maps[static_cast<std::size_t>(side.block.value)][static_cast<std::size_t>(side.side)];
  }
  FaceMap& map(BlockSide side) {
    return maps[static_cast<std::size_t>(side.block.value)][static_cast<std::size_t>(side.side)];
  }
  /// The map of a face's first use, whose frame is the face's.
  const FaceMap& map(const HexFace& face) const { return map(face.uses.front().side); }
  Eigen::Vector3d vertex(geometry::HexVertexId id) const {
    return vertices[static_cast<std::size_t>(id.value)];
  }
};

/// The blocks of a model by themselves.
std::vector<Hexahedron> hexahedra(const HexModel& model);
/// Maps of all faces, by arc length.
std::vector<std::array<FaceMap, 6>> face_maps(const std::vector<Hexahedron>& blocks);
/// Diagonal of the box of all corners and faces' middles, m.
double size_of(const std::vector<Hexahedron>& blocks);

}  // namespace isopatch::segmentation
