#pragma once

#include <string>

#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/patch_set.hpp"

namespace isopatch::geometry {

/// Stores patches, boundaries, interfaces and names in a group such as "/patch_set".
void write_patch_set(Hdf5Writer& file, const std::string& group, const PatchSet& set);

/// The value that was written, to the last bit.
/// @throws Error bad_format        a dataset that is missing, damaged or of another kind
/// @throws Error invalid_argument  numbers that are no patches; faces are left for `connect` to judge
PatchSet read_patch_set(const Hdf5Reader& file, const std::string& group);

}  // namespace isopatch::geometry
