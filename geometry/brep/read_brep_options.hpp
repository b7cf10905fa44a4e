#pragma once

#include <optional>

#include "geometry/base/guarded_process.hpp"
#include "geometry/base/progress.hpp"
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
  /// 0 bytes: three quarters of the machine's memory, otherwise at least 50 MB.
  GuardLimits limits = {.seconds = 0, .bytes = 0};
  Progress progress = {};
};

}  // namespace isopatch::geometry
