#pragma once

#include <string>
#include <vector>

#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"

namespace isopatch::app {

/// Stores bytes of any kind: texts in HDF5 end at a zero.
void write_bytes(geometry::Hdf5Writer& file, const std::string& path, const std::string& bytes);
/// @throws Error bad_format  what `write_bytes` did not write
std::string read_bytes(const geometry::Hdf5Reader& file, const std::string& path);

/// Stores texts of any content, the empty one too.
void write_texts(geometry::Hdf5Writer& file, const std::string& path, const std::vector<std::string>& texts);
/// @throws Error bad_format  what `write_texts` did not write
std::vector<std::string> read_texts(const geometry::Hdf5Reader& file, const std::string& path);

}  // namespace isopatch::app
