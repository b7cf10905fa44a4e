#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isopatch::geometry {

/// What the global section of an IGES file says of lengths.
struct IgesHeader {
  bool has_unit = false;              ///< otherwise millimetres are taken
  std::string unit;                   ///< "mm", "inch", ...
  double metres = 1e-3;               ///< of one unit
  double scale = 1;                   ///< lengths of the file are this many times the real ones
  std::vector<std::string> warnings;  ///< a flag against a name, a missing unit, a scale
};

/// Reads the section.
/// @throws Error bad_format  with "source: ": there is none, it does not end, a scale that is not positive
IgesHeader iges_header(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
