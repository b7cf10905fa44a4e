#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep_parts.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Triangles that are one face.
struct Region {
  std::vector<int> triangles;
  std::optional<geometry::Carrier> carrier;      ///< nothing: a freeform surface
  std::optional<geometry::NurbsSurface> spline;  ///< what a freeform surface is
  /// Whether the solid's outward normal is against the spline's S_u x S_v or the carrier's: away from the
  /// axis or the centre, along the plane's axis.
  bool reversed = false;
  double deviation = 0;  ///< largest distance of a vertex from the surface, m
  double area = 0;       ///< of the triangles, m^2
};

/// All triangles of a mesh, each in one region.
struct Regions {
  std::vector<Region> regions;
  std::vector<int> of_triangle;
};

}  // namespace isopatch::segmentation
