#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/read_brep_options.hpp"

namespace isopatch::geometry {

/// What came of a CAD file.
struct CadFile {
  std::vector<KernelSolid> bodies;
  std::vector<std::string> missing;  ///< bodies and faces that could not be made, references into nothing
  std::vector<std::string> warnings;
  std::string unit;  ///< "mm", or what was taken and why
};

/// Reads a STEP, IGES or .brep file in this very process: checks what can be checked before, lets the CAD
/// library read it, and compares what the file lists with what came.
/// @throws Error bad_format, unsupported  with the file's name, the line and the entity; unless
/// `allow_partial`, also for bodies and faces that could not be made
CadFile read_cad_file(const std::filesystem::path& path, BrepFormat format, const ReadBrepOptions& options);

}  // namespace isopatch::geometry
