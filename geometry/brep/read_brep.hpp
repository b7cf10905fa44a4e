#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/guarded_process.hpp"
#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/read_brep_options.hpp"
#include "geometry/brep/sew_options.hpp"

namespace isopatch::geometry {

/// A body of a file.
struct BrepFile {
  Brep brep;
  /// What the file calls it (in STEP files the product), otherwise the file's name without ending. Bodies of
  /// one name have "#1", "#2", ... behind it from the second on.
  std::string name;
  double largest_correction = 0;  ///< m that points were moved to close gaps
};

/// What was read of a file.
struct BrepSet {
  std::vector<BrepFile> bodies;
  std::vector<std::string>
      missing;  ///< sentences about what could not be read; only where `accept_open` is set
  std::vector<std::string> warnings;  ///< sentences, without the file's name
  std::string unit;                   ///< of the file: "mm", "as given", "m, since the format states none"
};

/// Whether a file's ending belongs to a format of solids: .step .stp .p21 .iges .igs .brep .brp .off.
bool is_brep_file(const std::filesystem::path& path);

/// All bodies of a file: STEP (.step, .stp, .p21), IGES (.iges, .igs), OpenCASCADE (.brep, .brp), G+Smo
/// solids (.xml), polyhedra (.off).
///
/// Bodies come out in metres, closed and with outward normals: solids, closed shells, and what loose faces
/// bound when sewn, if their gaps are small; a part that an assembly places several times comes as often.
/// Names and colours of faces survive from STEP.
///
/// STEP, IGES and .brep files are read by the CAD library in a process of their own; nothing in them can end
/// or stop the caller.
/// @throws Error io            the file cannot be read
/// @throws Error bad_format    its content breaks its format, the library dies of it, part of it cannot be
/// read
/// @throws Error unsupported   an unknown format, nothing that bounds a solid
/// @throws Error not_manifold  an open or overused edge, naming where; a zero-length edge
BrepSet read_breps(const std::filesystem::path& path, const ReadBrepOptions& options = {});

/// The file's only solid.
/// @throws Error unsupported  for several solids, naming them
BrepFile read_brep(const std::filesystem::path& path, const ReadBrepOptions& options = {});

}  // namespace isopatch::geometry
