#pragma once

#include <string>

#include "geometry/hex/block_face.hpp"
#include "geometry/hex/hex_topology.hpp"
#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"

namespace isopatch::geometry {

/// Stores a complex of hexahedra in a group such as "/complex".
void write_hex_topology(Hdf5Writer& file, const std::string& group, const HexTopology& topology);

/// @throws Error bad_format        a dataset that is missing, damaged or of another kind
/// @throws Error invalid_argument  numbers that are no complex, as `validate` says
HexTopology read_hex_topology(const Hdf5Reader& file, const std::string& group);

/// Stores which faces of solids the sides of blocks are, in a group of their own.
void write_block_faces(Hdf5Writer& file, const std::string& group, const BlockFaces& faces);

/// @throws Error as `read_hex_topology` does
BlockFaces read_block_faces(const Hdf5Reader& file, const std::string& group);

}  // namespace isopatch::geometry
