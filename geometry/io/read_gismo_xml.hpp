#pragma once

#include <string>
#include <string_view>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Reads the volume patches of a G+Smo XML file.
///
/// Patches are the `Geometry` elements of type TensorBSpline3 and TensorNurbs3 that the `MultiPatch` element
/// lists, in its order, or all of them where there is none. `boundary` elements with a `name` attribute
/// become named boundaries, `interfaces` become stated interfaces. Curves and surfaces are left
/// out.
///
/// Knots, control points and weights may be base64 (`format="B64Float64"`). Control points are places in
/// space, not multiplied with their weights.
///
/// @param text    the file's content
/// @param source  its name, for messages
/// @throws Error bad_format   broken XML, wrong counts, numbers or knots, with "source:line: "
/// @throws Error unsupported  other volumes (hierarchical splines), points not in space
/// @cost   O(text)
/// @source G+Smo 0.8 and later, gsIO/gsXmlUtils.hpp: only the format
PatchSet read_gismo_xml(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
