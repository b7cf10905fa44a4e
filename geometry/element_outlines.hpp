#pragma once

#include <array>
#include <vector>

#include "geometry/divided_surface.hpp"
#include "geometry/parameter_polygon.hpp"

namespace isopatch::geometry {

/// An element of one surface in the parameters of another.
struct ElementOutline {
  std::array<int, 2> element = {0, 0};
  ParameterPolygon on_other;
  bool is_cut = false;  ///< where the other surface ends, which outlines of straight elements leave
};

/// The elements of one surface in the parameters of another where the two are one surface.
///
/// Where lines of elements are straight there, elements have four corners, and go on beyond the other surface
/// as if it continued along its tangents. Others get 16 to 64 segments a side, and only what of them lies on
/// the other surface: where they leave it their outline runs along its border.
///
/// @param same_point  how far the surfaces may be apart, model units
/// @return  elements that have nothing on the other surface are left out, if they are not straight
/// @cost    a few nearest points per segment
std::vector<ElementOutline> element_outlines(const DividedSurface& surface, const DividedSurface& other,
                                             double same_point);

}  // namespace isopatch::geometry
