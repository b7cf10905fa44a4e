#pragma once

#include <string>
#include <vector>

#include "geometry/brep/read_brep.hpp"
#include "geometry/hex/block_face.hpp"
#include "geometry/hex/hex_topology.hpp"

namespace isopatch::segmentation {

/// Solids that are topological hexahedra, and how they meet: what the parameterization starts from. Lengths
/// are metres.
///
/// All of it can be stored: `geometry::to_bytes`, `write_hex_topology`, `write_block_faces`.
struct HexModel {
  std::vector<geometry::BrepFile> solids;  ///< block b is solid b
  /// By block: the body that it is or is a part of, which patches and their outer faces are called after.
  std::vector<std::string> bodies;
  geometry::HexTopology topology;
  geometry::BlockFaces faces;  ///< which face of its solid each side of a block is

  const geometry::BlockFace& face(geometry::BlockSide side) const {
    return faces[static_cast<std::size_t>(side.block.value)][static_cast<std::size_t>(side.side)];
  }
  const std::string& name(geometry::BlockId block) const {
    return solids[static_cast<std::size_t>(block.value)].name;
  }
};

/// "block:face" of a side, by their names.
std::string label_of(const HexModel& model, geometry::BlockSide side);

/// @throws Error invalid_argument  parts that do not belong together: other numbers of blocks, faces that
/// their solids do not have
void validate(const HexModel& model);

}  // namespace isopatch::segmentation
