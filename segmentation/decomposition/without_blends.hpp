#pragma once

#include <string>

#include "geometry/brep/brep.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::segmentation {

/// A solid without the rounds that are in the way of dividing it, and what that changed.
struct WithoutBlends {
  geometry::Brep brep;
  int removed = 0;            ///< faces
  double largest_radius = 0;  ///< m
  double volume_change = 0;   ///< of the solid, m^3
  std::string why_kept = {};  ///< where rounds are in the way and cannot be removed
};

/// The solid as it is where blends are kept or none is in the way.
WithoutBlends without_blends(const geometry::Brep& solid, const DecompositionOptions& options);

/// "4 rounds of 5 mm at most removed, volume +0.31 %"; "" if nothing was to be removed.
std::string text_of(const WithoutBlends& removal);

}  // namespace isopatch::segmentation
