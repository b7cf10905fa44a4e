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

/// A solid with straight edges: plane faces, bilinear ones for quadrilaterals that are not plane.
///
/// Vertex i and face i are those of the polyhedron, if each vertex is used.
/// @param polyhedron  in m, counter-clockwise faces seen from outside, or all clockwise
/// @throws Error not_manifold  an edge without its neighbour or with two, naming the vertices
/// @throws Error invalid_argument  a polygon with more than four corners that is not plane, a vertex number
/// out of range
Brep make_brep(const Polyhedron& polyhedron, const SewOptions& options = {});

}  // namespace isopatch::geometry
