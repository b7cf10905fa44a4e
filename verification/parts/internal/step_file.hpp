#pragma once

#include <string>

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// Writes a part as a STEP file in mm, with the names of its faces.
/// @throws std::runtime_error where no face, or more than one, is at the place of a name
void write_step(const Part& part, const std::string& name, const std::string& path);

}  // namespace isopatch::parts
