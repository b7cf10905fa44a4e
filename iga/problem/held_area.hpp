#pragma once

#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// How well the part of some faces that a support is to hold rigidly is met by the functions that it holds.
struct HeldArea {
  double asked = 0;          ///< of the faces in the support's region, m^2
  double held = 0;           ///< integral of the functions that are held over the faces, m^2
  bool has_element = false;  ///< whether an element lies in the region as a whole
};

/// Of a support of whole faces `held` is `asked`. Where no element lies in the region, the support is wider
/// or narrower than it says by as much as itself.
/// @cost  that of integrating a load on the faces
HeldArea held_area(const std::vector<geometry::NurbsVolume>& patches, const Support& support);

}  // namespace isopatch::iga
