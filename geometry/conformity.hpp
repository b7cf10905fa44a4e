#pragma once

#include "geometry/interface_search.hpp"

namespace isopatch::geometry {

/// Refuses boundary faces that were probably meant to be interfaces.
///
/// A near miss is a pair whose points of equal parameters differ by less than `tolerance.near_miss` times
/// `size` and by less than 2 % of the narrower face's width, unless the two are the sides of a thin wall.
/// Faces of which one lies on the other, but with other parameters or another outline (a T-joint), are
/// refused as well.
///
/// @param faces  the boundary faces found by find_interfaces
/// @throws Error not_conforming, naming the faces, the distance and the place
/// @cost   O(faces log faces + pairs of overlapping boxes)
void check_conforming(const std::vector<NurbsVolume>& patches, const std::vector<PatchFace>& faces,
                      const Tolerance& tolerance, double size, const FaceLabel& label);

/// Checks that every stated interface is among the ones found, in its orientation.
/// @throws Error not_conforming, naming the faces and how far they are from each other
void check_stated(const std::vector<NurbsVolume>& patches, const std::vector<Interface>& found,
                  const std::vector<StatedInterface>& all_stated, const Tolerance& tolerance, double size,
                  const FaceLabel& label);

}  // namespace isopatch::geometry
