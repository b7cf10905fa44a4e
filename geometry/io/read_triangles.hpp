#pragma once

#include <filesystem>

#include "geometry/io/measured_triangles.hpp"

namespace isopatch::geometry {

/// Whether a file's ending belongs to a format of triangles: .stl, .obj, .ply, .3mf.
bool is_triangle_file(const std::filesystem::path& path);

/// The triangles of a file (.stl, .obj, .ply, .3mf, .off), as they are there; polygons are divided.
/// @throws Error io          the file cannot be read
/// @throws Error bad_format  its content breaks its format
/// @throws Error unsupported  another ending; as of `read_3mf`
MeasuredTriangles read_triangles(const std::filesystem::path& path);

}  // namespace isopatch::geometry
