#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/polyhedron.hpp"
#include "geometry/trimmed_surface.hpp"

namespace isopatch::geometry {

/// The boundary of one solid of a G+Smo file, face by face in the order of the file.
struct SolidBoundary {
  std::string name;  ///< "volume 1" if the file has several, counted from 0, else ""
  /// All points of the file, and the corners of this solid's faces; no faces where the file has only trimmed
  /// surfaces.
  Polyhedron corners;
  /// The surface of each face; nothing where the file leaves it to be made from the corners.
  std::vector<std::optional<TrimmedSurface>> surfaces;
};

/// Whether a G+Smo XML text has a solid or trimmed surfaces (and not volume patches).
bool is_gismo_solid(std::string_view text);

/// Reads the solids of a G+Smo XML text: `Solid` elements with `Vertex`, `Face` and `Volume` lists, whose
/// faces name `TrimSurface` elements by id or -1; without `Solid`, all trimmed surfaces make one.
///
/// @param text    the file's content
/// @param source  its name, for messages
/// @throws Error bad_format   broken XML, wrong counts, numbers, knots or references, with "source:line: "
/// @throws Error unsupported  a file with neither, points not in space, other surfaces
/// @cost   O(text)
/// @source G+Smo 0.8 and later, gsIO/gsXmlUtils.hpp: only the format
std::vector<SolidBoundary> read_gismo_solids(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
