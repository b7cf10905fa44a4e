#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/divided_surface.hpp"

namespace isopatch::geometry {

/// Quadrature points along one direction of a face and their places on another face.
struct SharedLine {
  std::vector<double> first;
  std::vector<double> second;
  std::vector<int> first_element;
  std::vector<int> second_element;
  std::vector<double> weights;  ///< in the parameters of the first face

  std::size_t size() const { return first.size(); }
};

/// The common refinement of two faces as a product of two lines.
struct SharedGrid {
  std::array<SharedLine, 2> lines;  ///< along the directions of the first face
  bool swapped = false;             ///< whether direction 0 of the first runs along direction 1 of the second

  /// The direction of the second face that runs along one of the first.
  int second_direction(int of_first) const { return swapped ? 1 - of_first : of_first; }
};

/// The common refinement of two faces whose lines of equal parameters are the same where they overlap, so
/// that all of its cells are rectangles on both: much cheaper than `common_refinement`, which is for any
/// faces.
///
/// @param points      Gauss points of a cell, per direction of the first face
/// @param same_point  how far the faces may be apart, model units
/// @return  nothing for other faces, and where no part is found that both have
/// @cost    a few nearest points per line of elements; else that of the surfaces' points on the grid
std::optional<SharedGrid> shared_grid(const DividedSurface& first, const DividedSurface& second,
                                      const std::array<int, 2>& points, double same_point);

}  // namespace isopatch::geometry
