#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/results/load_input.hpp"
#include "app/solids/describe_solid.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// The bodies of a file and what reading it gave cause to say.
struct LoadedSolids {
  std::vector<SolidReport> bodies;
  std::vector<std::string> missing;  ///< what of the file could not be read
  std::vector<std::string> warnings;
  std::string unit;  ///< of the file, as of `geometry::BrepSet`
};

/// All bodies of a file, also open ones, with what `check` finds.
/// @throws Error as `geometry::read_breps` does; invalid_argument for a length unit that is none
LoadedSolids load_solids(const InputFile& input, const Progress& progress = {});

}  // namespace isopatch::app
