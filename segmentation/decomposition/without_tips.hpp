#pragma once

#include <string>
#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// A solid whose drill tips end in flats, and what that changed.
struct WithoutTips {
  geometry::Brep brep;
  /// A tip that was made flat.
  struct Flat {
    std::string face;       ///< the tip's, as messages name it
    Eigen::Vector3d place;  ///< of the apex that it had, m
    double radius;          ///< m
  };
  std::vector<Flat> flats = {};
  double volume_change = 0;   ///< of the solid, m^3
  std::string why_kept = {};  ///< where there are tips and the CAD library cannot flatten them
};

/// Gives every drill tip a flat of a quarter of its radius, about as wide as the chisel edge of the drill:
/// no regular patch ends in the apex of a cone. Solids without tips stay as they are.
WithoutTips without_tips(const geometry::Brep& solid);

/// "1 drill tip ends in a flat: face 14 at (52.4, 25, 25) mm in one of 2.25 mm radius; volume +0.0012 %", of
/// several the first four; "" if there were none.
std::string text_of(const WithoutTips& flattening);

}  // namespace isopatch::segmentation
