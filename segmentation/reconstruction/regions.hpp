#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep_parts.hpp"

namespace isopatch::segmentation {

/// Triangles that are one face.
struct Region {
  std::vector<int> triangles;
  std::optional<geometry::Carrier> carrier;  ///< nothing: a freeform surface
  /// Whether the solid's outward normal is against the carrier's: away from the axis or the centre, along the
  /// plane's axis.
  bool reversed = false;
  double deviation = 0;  ///< largest distance of a vertex from the carrier, m
  double area = 0;       ///< of the triangles, m^2
};

/// All triangles of a mesh, each in one region.
struct Regions {
  std::vector<Region> regions;
  std::vector<int> of_triangle;
};

}  // namespace isopatch::segmentation
