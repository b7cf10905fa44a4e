#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include "geometry/brep/opencascade/internal/shape_kernel.hpp"

namespace isopatch::geometry {

/// Faces that bound one body, by their numbers: each shell's, the outer one first, then cavities.
using FaceBody = std::vector<std::vector<std::size_t>>;

/// Groups faces that share edges into bodies.
///
/// Faces connected over edges that two of them share make a shell. A closed shell inside another is its
/// cavity, one inside a cavity is a body again. Where two bodies touch in equal faces, which makes edges of
/// four faces, each gets one of the two.
std::vector<FaceBody> face_bodies(const std::vector<TopoDS_Face>& faces);

/// The body as a solid with outward normals; a shell if it is open.
/// @param metres  that a unit of the shapes measures
ShapeInput oriented_body(const std::vector<TopoDS_Face>& faces, const FaceBody& body, double metres);

}  // namespace isopatch::geometry
