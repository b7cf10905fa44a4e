#pragma once

#include <string>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A G+Smo XML file of a model: patches, interfaces with direction maps, outer faces, named boundaries.
///
/// Patches, sides and directions are named as in the model's input: patches that were turned around are
/// turned back. Numbers have the fewest digits that read back to the same double; for patches that were never
/// turned around, reading the file restores every bit.
///
/// @return  the file's content, for isopatch::write_file
/// @cost    O(control points)
/// @source  G+Smo 0.8: gsIO, boundaryInterface for the direction maps
std::string to_gismo_xml(const MultiPatch& model);

/// The same for patches whose interfaces are not known; only named boundaries are listed.
std::string to_gismo_xml(const PatchSet& patches);

}  // namespace isopatch::geometry
