#pragma once

#include <filesystem>

#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// Reads patches as geometry::read_patches does; where that knows no such format, the message lists the
/// formats of solids too.
/// @param solids_too  whether the command takes solids
/// @throws Error as geometry::read_patches does
geometry::PatchSet read_model_file(const std::filesystem::path& path, bool solids_too = true);

}  // namespace isopatch::app
