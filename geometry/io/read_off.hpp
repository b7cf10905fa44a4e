#pragma once

#include <string>
#include <string_view>

#include "geometry/polyhedron.hpp"

namespace isopatch::geometry {

/// Reads an Object File Format text: "OFF", the counts, points, polygons. Colours after the polygons are
/// passed over.
///
/// @param text    the file's content
/// @param source  its name, for messages
/// @throws Error bad_format  with "source:line: " for wrong counts, numbers or vertices
/// @cost   O(text)
/// @source Geomview manual, section "OFF Files"
Polyhedron read_off(std::string_view text, const std::string& source);

/// The same as text, 17 digits.
std::string to_off(const Polyhedron& polyhedron);

}  // namespace isopatch::geometry
