#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/base/tolerance.hpp"
#include "geometry/interface.hpp"

namespace isopatch::geometry {

/// How messages name a face.
using FaceLabel = std::function<std::string(PatchFace)>;

/// The faces of all patches by kind: interfaces, boundary, without area.
struct FaceSets {
  std::vector<Interface> interfaces;
  std::vector<PatchFace> boundary;    ///< faces with an area that meet no other
  std::vector<PatchFace> degenerate;  ///< faces without an area
};

/// Finds the pairs of faces that agree to `tolerance.same_point` times `size`, in the orientation stated for
/// the pair or else in one of the eight. A stated pair that does not is left out.
/// @param patches  right-handed
/// @param stated   interfaces that are known, faces as in `patches`
/// @return interfaces ordered by their faces, of which the first is the smaller
/// @param size     of the model, model units
/// @throws Error not_conforming for more than two faces in one place, and for two that lie on the same side
/// @cost   O(faces log faces) for the search, O(control points) per candidate
FaceSets find_interfaces(const std::vector<NurbsVolume>& patches, const std::vector<StatedInterface>& stated,
                         const Tolerance& tolerance, double size, const FaceLabel& label);

/// Pairs of points no further apart than `radius`, each with the smaller index first.
/// @cost O(n log n) plus the pairs in slabs as thick as the radius
std::vector<std::pair<std::size_t, std::size_t>> close_pairs(const std::vector<Eigen::Vector3d>& points,
                                                             double radius);

/// Length of the line across a patch from the middle of a side to the middle of the opposite one; model
/// units.
double thickness(const NurbsVolume& patch, Side side);

}  // namespace isopatch::geometry
