#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/guarded_process.hpp"
#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/sew_options.hpp"

namespace isopatch::geometry {

struct ReadBrepOptions {
  /// Metres that one unit of the file measures, for files that do not say it (.brep, .xml, .off, STEP and
  /// IGES files without a unit). Positive. Giving it for a file that states its unit is an error, unless it
  /// is 1.
  std::optional<double> length_unit = {};  // 1 where needed and not given; 0.001 for STEP and IGES
  /// How faces are joined that do not share their edges; `accept_open` also takes a boundary with free or
  /// overused edges from any format as it is, for `check` to report.
  SewOptions sew = {};
  /// Whether bodies and faces that cannot be read, and bodies that are not closed, are a warning and left
  /// out. Otherwise they are an error.
  bool allow_partial = false;
  /// For the process that reads STEP, IGES and .brep files; 0 s: a minute and ten seconds for each megabyte,
  /// 0 bytes: three quarters of the machine's memory.
  GuardLimits limits = {.seconds = 0, .bytes = 0};
  Progress progress = {};
};

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
