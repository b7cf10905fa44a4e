#pragma once

#include <filesystem>

namespace isopatch::app {

/// Whether a file holds CAD solids: by its ending, or a G+Smo .xml by its content.
bool is_solid_file(const std::filesystem::path& path);

}  // namespace isopatch::app
