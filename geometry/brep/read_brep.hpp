#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/sew_options.hpp"

namespace isopatch::geometry {

struct ReadBrepOptions {
  /// Metres that one unit of the file measures, for formats that do not say it (.brep, .xml, .off). Positive.
  /// STEP and IGES files state their unit; giving it for them is an error.
  std::optional<double> length_unit = {};  // 1 where needed and not given
  /// How faces are joined that do not share their edges; `accept_open` also takes a boundary with free or
  /// overused edges from any format as it is, for `check` to report.
  SewOptions sew = {};
};

/// What was read.
struct BrepFile {
  Brep brep;
  std::string name;               ///< of the solid in the file
  double largest_correction = 0;  ///< m that points were moved to close gaps
};

/// Whether a file's ending belongs to a format of solids: .step .stp .iges .igs .brep .off.
bool is_brep_file(const std::filesystem::path& path);

/// All solids of a file: STEP (.step, .stp), IGES (.iges, .igs), OpenCASCADE (.brep), G+Smo solids (.xml),
/// polyhedra (.off).
///
/// Solids come out in metres, closed and with outward normals. Names and colours of faces survive from STEP.
/// Files without solids but with faces are sewn, if their gaps are small.
///
/// @throws Error io            the file cannot be read
/// @throws Error bad_format    its content breaks its format
/// @throws Error unsupported   an unknown format, nothing that bounds a solid
/// @throws Error not_manifold  an open or overused edge, naming where; a zero-length edge
std::vector<BrepFile> read_breps(const std::filesystem::path& path, const ReadBrepOptions& options = {});

/// The file's only solid.
/// @throws Error unsupported  for several solids, naming them
BrepFile read_brep(const std::filesystem::path& path, const ReadBrepOptions& options = {});

}  // namespace isopatch::geometry
