#pragma once

#include <string>

#include "geometry/brep/part21.hpp"
#include "geometry/brep/step_units.hpp"

namespace isopatch::geometry {

/// Points and directions have one to three numbers.
/// @throws Error bad_format  with the line and the entity
void require_coordinates(const Part21File& file);

/// The file for the CAD library: units said so that it follows them, numbers so that it takes them for
/// such, texts in UTF-8.
std::string kernel_text(const Part21File& file, const StepUnits& units);

/// A name of the file for people: bytes that are no UTF-8 are taken as Latin-1 (Windows-1252), which is what
/// programs write that do not encode.
std::string utf8_name(std::string_view bytes);

}  // namespace isopatch::geometry
