#pragma once

#include <string>

#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/patch_connections.hpp"

namespace isopatch::geometry {

/// Stores how patches meet in a group such as "/model".
void write_connections(Hdf5Writer& file, const std::string& group, const PatchConnections& connections);

/// @throws Error bad_format        a dataset that is missing, damaged or of another kind
/// @throws Error invalid_argument  numbers that are no records; whether the faces exist, `validate` says
PatchConnections read_connections(const Hdf5Reader& file, const std::string& group);

}  // namespace isopatch::geometry
