#pragma once

#include <string>
#include <vector>

#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// Stores degrees, knots, weights and control points of volumes in a group such as "/patches".
void write_volumes(Hdf5Writer& file, const std::string& group, const std::vector<NurbsVolume>& volumes);

/// The volumes that were written, to the last bit.
/// @throws Error bad_format        a dataset that is missing, damaged or of another kind
/// @throws Error invalid_argument  numbers that are no volumes
std::vector<NurbsVolume> read_volumes(const Hdf5Reader& file, const std::string& group);

}  // namespace isopatch::geometry
