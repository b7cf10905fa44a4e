#pragma once

#include <string>
#include <string_view>

#include "geometry/io/measured_triangles.hpp"

namespace isopatch::geometry {

/// Reads what a 3MF package is to be built of: all items of its root model, their components placed, those in
/// other parts of the package too. Colours, materials, slices, beams and supports are passed over; where a
/// model has no list of items, all its objects of the type "model" count.
/// @throws Error bad_format   no ZIP archive, or a damaged one; a package without a model; XML that breaks
///     the format, with the part's name and the line
/// @throws Error unsupported  an encrypted package; a part of more than 1 GB; more than 20 million triangles
///     or 100,000 objects, once all are placed
/// @cost   O(bytes of the models, unpacked); an object counts as often as it is placed
/// @source 3MF Consortium, Core Specification 1.3, 2021; Production Extension 1.1.2 (parts elsewhere)
MeasuredTriangles read_3mf(std::string_view bytes, const std::string& source);

}  // namespace isopatch::geometry
