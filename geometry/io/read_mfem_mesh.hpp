#pragma once

#include <string>
#include <string_view>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Reads the volume patches of an MFEM NURBS mesh, version 1.0 or 1.1, in any of its three forms:
/// coefficients numbered over the whole mesh (vertices, edges, faces, interiors), coefficients patch by patch
/// (`NURBS_patches`), and knot vectors with control points per patch (`patches`).
///
/// Control points of `patches` are multiplied with their weights, unless they are `controlpoints_cartesian`;
/// in the two other forms they are places in space. How version 1.1 spaces the knots of later refinements is
/// dropped.
///
/// Patches of NC-patch meshes meet in parts of faces: a face that others divide has their coefficients. What
/// the file says of its vertices' places is that of its control points again, and passed over.
///
/// Boundary elements become boundaries named "attribute N". Faces shared by two patches become listed
/// interfaces.
///
/// @param text    the file's content
/// @param source  its name, for messages
/// @throws Error bad_format   wrong counts, numbers, knots or connections, with "source:line: "
/// @throws Error unsupported  meshes of surfaces or curves, periodic or partly active ones, NC-patch
/// meshes
///                            whose patches were divided later, other versions
/// @cost   O(text)
/// @source MFEM 4.6 and 4.8, mesh/nurbs.cpp and mesh.cpp: only the format and its numbering
PatchSet read_mfem_mesh(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
