#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// Reads a stereolithography file, text or binary: what it is, its length tells, not its first word.
///
/// Vertices are repeated for each triangle, as in the file. Normals are passed over: the vertices' order says
/// the same.
/// @param source  the file's name, for messages
/// @throws Error bad_format  with "source:line: " or the number of the triangle
/// @cost   O(text)
/// @source 3D Systems, Stereolithography Interface Specification, 1989
TriangleMesh read_stl(std::string_view text, const std::string& source);

/// The same as a binary file; coordinates are rounded to 32 bits.
std::string to_stl(const TriangleMesh& mesh);

}  // namespace isopatch::geometry
