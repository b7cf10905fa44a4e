#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/sew_options.hpp"
#include "geometry/polyhedron.hpp"
#include "geometry/trimmed_surface.hpp"

namespace isopatch::geometry {

struct SewnBrep {
  Brep brep;
  double largest_correction = 0;  ///< m; largest distance between what two faces had as their common edge
};

/// A solid from trimmed surfaces that meet along their loops: finds the common edges by their curves in
/// space.
///
/// Face i of the solid is surface i. Normals come out pointing outwards, whatever the surfaces' own.
/// @param faces  control points in m
/// @throws Error not_manifold  an edge that no other face shares, or three do: names face, curve and place
/// @throws Error invalid_argument  a loop that does not close
SewnBrep sew(const std::vector<TrimmedSurface>& faces, const SewOptions& options = {});

/// The faces of a solid as NURBS surfaces, exactly; the inverse of `sew`. Surface i is face i, in m. Loops
/// run as their surface's normal has it, not the solid's.
/// @throws Error unsupported  surfaces without a rational form
std::vector<TrimmedSurface> trimmed_surfaces(const Brep& brep);

/// A solid with straight edges: plane faces, bilinear ones for quadrilaterals that are not plane, smooth ones
/// of little bending for other polygons (1e-7 of the size off their edges, or 1e-4 at most).
///
/// Vertex i and face i are those of the polyhedron, if each vertex is used.
/// @param polyhedron  in m, counter-clockwise faces seen from outside, or all clockwise
/// @throws Error not_manifold  an edge without its neighbour or with two, naming the vertices
/// @throws Error invalid_argument  a polygon with more than four corners that is not plane and touches itself
/// as seen along its normal, one whose outline crosses itself, a vertex number out of range
Brep make_brep(const Polyhedron& polyhedron, const SewOptions& options = {});

/// The vertices of a solid and the corners of its faces, in m. What lies between them is lost unless edges
/// are straight.
/// @throws Error unsupported  a face with inner loops or a seam
Polyhedron corners(const Brep& brep);

}  // namespace isopatch::geometry
