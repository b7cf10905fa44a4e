#pragma once

#include <filesystem>
#include <string>

#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// Patches that solids became and the report of it, as the bytes of an HDF5 file: numbers to the last bit.
std::string patch_file_bytes(const segmentation::Parameterization& patches);

/// @return  what was written, but for the names of options
/// @throws Error io          the file cannot be read
/// @throws Error bad_format  no such file, or a damaged one
segmentation::Parameterization read_patch_file(const std::filesystem::path& path);

}  // namespace isopatch::app
