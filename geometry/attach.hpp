#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Adds a patch between each of some faces and its image under an affine map: a ring in a bore, a pad on a
/// face, a longer pipe.
///
/// The new patches come behind the others, in the order of the faces. Their first two directions are those of
/// `face_surface`, the third is straight from the face (front) to its image (back). Patches on faces that
/// meet in an edge meet too. Faces that are attached to leave the named boundaries.
///
/// @param map   model units; affine, so images of rational faces are exact
/// @param name  of a boundary that gets the images; empty for none
/// @throws Error invalid_argument  a face that does not exist, a face given twice, a map that leaves a face
///                                 where it is
PatchSet attached(PatchSet set, const std::vector<PatchFace>& faces, const Eigen::Affine3d& map,
                  const std::string& name = "");

}  // namespace isopatch::geometry
