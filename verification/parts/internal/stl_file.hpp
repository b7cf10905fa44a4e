#pragma once

#include <string>

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// Writes a part as a binary STL file in mm, as CAD programs export it: chords of a thousandth of the part's
/// size at most, turns of 12 degrees.
/// @throws std::runtime_error  the file cannot be written
void write_stl(const Part& part, const std::string& path);

}  // namespace isopatch::parts
