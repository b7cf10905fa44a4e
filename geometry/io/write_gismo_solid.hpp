#pragma once

#include <string>

#include "geometry/io/read_gismo_solid.hpp"

namespace isopatch::geometry {

/// A solid as G+Smo XML: its trimmed surfaces, and a `Solid` element with corners, faces and one volume. 17
/// digits. Faces without a surface get the number -1.
std::string to_gismo_solid(const SolidBoundary& solid);

}  // namespace isopatch::geometry
