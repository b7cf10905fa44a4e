#pragma once

#include <string>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// A solid whose drill tips end in flats, and what that changed.
struct WithoutTips {
  geometry::Brep brep;
  int flattened = 0;          ///< tips
  double largest_radius = 0;  ///< of their flats, m
  double volume_change = 0;   ///< of the solid, m^3
  std::string why_kept = {};  ///< where there are tips and the CAD library cannot flatten them
};

/// Gives every drill tip a flat of a quarter of its radius, about as wide as the chisel edge of the drill:
/// no regular patch ends in the apex of a cone. Solids without tips stay as they are.
WithoutTips without_tips(const geometry::Brep& solid);

/// "2 drill tips end in flats of 0.00175 m radius at most, volume +0.0012 %"; "" if there were none.
std::string text_of(const WithoutTips& flattening);

}  // namespace isopatch::segmentation
