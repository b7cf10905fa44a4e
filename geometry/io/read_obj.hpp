#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// Reads the polygons of a Wavefront file: lines "v" and "f", also counted from the end; normals, textures,
/// materials, groups, lines and points are passed over.
/// @throws Error bad_format  with "source:line: "
/// @cost   O(text)
/// @source Wavefront Technologies, Advanced Visualizer, appendix B1
TriangleMesh read_obj(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
