#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/hex/assemble_topology.hpp"
#include "segmentation/parameterization/internal/face_map.hpp"

namespace isopatch::segmentation {

/// Where a face lies in a larger one, in that one's frame.
struct OutlineInSide {
  std::array<std::array<double, 2>, 4> corners{};  ///< the face's (0, 0), (1, 0), (0, 1) and (1, 1)
  std::vector<std::array<double, 2>> points;       ///< all around, counterclockwise
  double distance = 0;                             ///< largest between the two that was found, m
};

/// Whether a face lies in another, and where: its corners, sides and some inner points do.
/// @param reach  largest distance between them, m
std::optional<OutlineInSide> lies_in(const FaceMap& part, const FaceMap& whole, double reach);

/// A side that lies in another one without being all of it.
struct SideInSide {
  geometry::BlockSide part, whole;
  OutlineInSide outline;
};

/// The topology of blocks that meet in whole sides and in parts of them: corners and edges of a part that are
/// those of the whole side are joined, its other corners divide the edges that they lie on.
geometry::HexTopology with_t_joints(int blocks, geometry::HexContacts contacts,
                                    const std::vector<SideInSide>& parts);

}  // namespace isopatch::segmentation
