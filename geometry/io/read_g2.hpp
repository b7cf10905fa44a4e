#pragma once

#include <string>
#include <string_view>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Reads the spline volumes of a GoTools .g2 file.
///
/// Every object must be a SplineVolume (type 700). Rational volumes store homogeneous coordinates
/// (x w, y w, z w, w). The format knows neither interfaces nor names.
///
/// @param text    the file's content
/// @param source  its name, for messages
/// @throws Error bad_format   wrong counts, numbers or knots, with "source:line: "
/// @throws Error unsupported  other objects (curves, surfaces), named, and points not in space
/// @cost   O(text)
/// @source GoTools, "The g2 format", and gotools-trivariate SplineVolume
PatchSet read_g2(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
