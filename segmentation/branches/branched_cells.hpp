#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A turned solid with branches as hexahedra.
struct BranchedCells {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  Eigen::Vector3d about;          ///< direction of the body's axis, unit
  int branches = 0;
};

/// The axis of the turned body that a solid looks like but for branches; nothing of others.
/// @throws Error unsupported  each body that it looks like has a branch of another kind: names a face
std::optional<Eigen::Vector3d> branched_about(const geometry::Brep& solid);

/// Divides a turned solid with branches: bosses and pipes that stand on its cylinders, bores and slots across
/// its axis. The body without them is divided as a turned solid (see `turned_cells`), so that each branch
/// begins within one side of a hexahedron; then the column of hexahedra below that side is divided as the
/// branch's outlines are drawn. What stands on a branch is divided as a stack.
/// @return  nothing for a solid that does not look so
/// @throws Error unsupported  it looks so, but a branch has no room on its cylinder, is of another kind, or a
/// drawing cannot be divided: names the place
/// @cost  some seconds
std::optional<BranchedCells> branched_cells(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
