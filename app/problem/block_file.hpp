#pragma once

#include <filesystem>
#include <string>

#include "segmentation/parameterization/read_blocks.hpp"

namespace isopatch::app {

/// Blocks as the bytes of an HDF5 file: their shapes, the bodies that they are parts of, which faces of those
/// their sides are, how they meet, T-joints included. Shapes are those of the CAD library, bit for bit; edges
/// and faces that blocks share stay shared.
std::string block_file_bytes(const segmentation::ReadBlocks& blocks);

/// @throws Error io          the file cannot be read
/// @throws Error bad_format  no such file, one of another version of isopatch, a damaged one
segmentation::ReadBlocks read_block_file(const std::filesystem::path& path);

}  // namespace isopatch::app
