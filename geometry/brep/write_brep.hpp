#pragma once

#include <filesystem>
#include <string>

#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

struct WriteBrepOptions {
  /// Of the file's coordinates: "mm", "m" or "in". STEP and IGES files say it; for .brep give it again when
  /// reading.
  std::string unit = "mm";
};

/// Writes a solid as STEP (.step, .stp), IGES (.iges, .igs) or for OpenCASCADE (.brep), whole or not at all.
/// STEP keeps the names and colours of faces.
/// @throws Error io           the file cannot be written
/// @throws Error unsupported  another ending; a polyhedron with edges that are not straight or faces with
/// inner loops
/// @throws Error invalid_argument  another unit
void write_brep(const std::filesystem::path& path, const Brep& brep, const WriteBrepOptions& options = {});

}  // namespace isopatch::geometry
