#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/brep/module.hpp"

namespace isopatch::geometry {

/// All endings of solids, for messages.
inline constexpr const char* brep_formats =
    ".step, .stp, .p21, .iges, .igs, .brep, .brp, .xml (G+Smo) and .off";

/// A file's ending in small letters: ".step".
std::string file_ending(const std::filesystem::path& path);

/// The format that an ending stands for, if the module reads it.
std::optional<BrepFormat> module_format(const std::string& ending);

}  // namespace isopatch::geometry
