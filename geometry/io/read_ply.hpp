#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// Reads the vertices and polygons of a polygon file, text or binary of either byte order; other elements and
/// properties are passed over.
/// @throws Error bad_format  with the source's name: an unknown type, numbers beyond the end
/// @throws Error unsupported  a property other than "vertex_indices" or "vertex_index" for the corners of
/// faces
/// @cost   O(text)
/// @source G. Turk, The PLY Polygon File Format, 1994
TriangleMesh read_ply(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
