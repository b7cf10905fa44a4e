#pragma once

#include <string>
#include <vector>

#include "geometry/brep/read_brep.hpp"

namespace isopatch::geometry {

/// Bodies with all that is known of them, as bytes: shapes as the CAD library keeps them, bit for bit, names
/// and colours of faces. Shapes that bodies share are shared again by those that come back.
///
/// For the same build of isopatch only, not for exchange: `write_brep` is.
std::string to_bytes(const std::vector<BrepFile>& bodies);

/// @throws Error bad_format  bytes that `to_bytes` did not make, or that have changed since
std::vector<BrepFile> bodies_from_bytes(const std::string& bytes);

}  // namespace isopatch::geometry
