#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/patch_set.hpp"

namespace isopatch::geometry {

/// Faces that meet as records of seven integers: two faces of two numbers, and three flags.
void write_interfaces(Hdf5Writer& file, const std::string& path,
                      const std::vector<StatedInterface>& interfaces);
/// Numbers that no face can have become -1, which those who connect patches refuse.
std::vector<StatedInterface> read_interfaces(const Hdf5Reader& file, const std::string& path);

/// Named boundaries: "boundary_count", and a group of its own for each in "boundaries".
void write_boundaries(Hdf5Writer& file, const std::string& group, const std::vector<Boundary>& boundaries);
std::vector<Boundary> read_boundaries(const Hdf5Reader& file, const std::string& group);

}  // namespace isopatch::geometry
