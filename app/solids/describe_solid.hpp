#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "segmentation/decomposition/prospect.hpp"

namespace isopatch::app {

/// A solid of a file with what was found about it.
struct SolidReport {
  geometry::BrepFile file;
  geometry::BrepReport report;
  /// What cutting it would mean; nothing for what is no solid or a topological hexahedron.
  std::optional<segmentation::Prospect> prospect = {};
  /// What its splines really are, as of `geometry::RecognisedBrep`; cutting takes them as that.
  std::string recognised = {};
};

/// What will be done with a solid in a study: "a topological hexahedron", "cuts will be looked for: 14 faces,
/// 3 concave edges (4, 7, 9)", "refused: its edge graph is not 3-connected ...".
std::string outlook_text(const std::optional<segmentation::Prospect>& prospect);

/// What `isopatch info` prints of a solid, in engineering units.
/// @param all  every face and edge; otherwise long lists are cut after 24 lines
std::string solid_text(const SolidReport& solid, bool all = false);

/// All solids of a file as JSON, SI units, angles in degrees, complete.
std::string solids_json_text(const std::vector<SolidReport>& solids, const std::string& unit,
                             const std::vector<std::string>& warnings);

}  // namespace isopatch::app
