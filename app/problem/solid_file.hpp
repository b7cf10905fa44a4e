#pragma once

#include <filesystem>
#include <string>

#include "app/problem/reconstructed_solids.hpp"

namespace isopatch::app {

/// Solids as the bytes of an HDF5 file, with the triangles that they were made of: shapes are those of the
/// CAD library, bit for bit.
std::string solid_file_bytes(const FoundSolids& solids);

/// @throws Error io          the file cannot be read
/// @throws Error bad_format  no such file, or a damaged one
FoundSolids read_solid_file(const std::filesystem::path& path);

}  // namespace isopatch::app
