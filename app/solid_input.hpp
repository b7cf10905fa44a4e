#pragma once

#include <filesystem>
#include <vector>

#include "app/describe_solid.hpp"
#include "app/load_input.hpp"

namespace isopatch::app {

/// Whether a file holds CAD solids: by its ending, or a G+Smo .xml by its content.
bool is_solid_file(const std::filesystem::path& path);

/// All solids of a file, also open ones, with what `check` finds.
/// @throws Error as `geometry::read_breps` does; invalid_argument for a length unit that is none
std::vector<SolidReport> load_solids(const InputFile& input);

}  // namespace isopatch::app
