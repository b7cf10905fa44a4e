#pragma once

#include <map>
#include <string>

#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

/// A solid with what its splines really are.
struct RecognisedBrep {
  Brep brep;
  std::map<SurfaceKind, int> faces;  ///< how many were splines before, by what they are
  int edges = 0;                     ///< that were splines before and are lines, circles or ellipses

  /// "12 spline faces are planes and cylinders"; empty where none was recognised.
  std::string text() const;
};

/// Planes, cylinders, cones, spheres and tori that a file has as splines become what they are, and so do the
/// lines, circles and ellipses between them.
///
/// Faces, edges, vertices, loops, names and colours stay, in their order; so does a solid without such faces,
/// and every face that is off at any place. Surfaces look outwards as before, their domains are others.
/// @param tolerance  largest distance of a face from what it is taken for, share of the size. What programs
/// write as exact splines agrees to a file's digits, 1e-12 or better; blends that only resemble a torus are
/// off by 1e-5 and more.
/// @cost some thousand points a spline face
RecognisedBrep recognise_carriers(const Brep& brep, double tolerance = 1e-8);

}  // namespace isopatch::geometry
