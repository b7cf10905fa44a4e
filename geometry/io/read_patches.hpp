#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Reads volume patches from a file of any supported format, which its content tells, not its name: G+Smo
/// XML, GoTools .g2, MFEM NURBS mesh.
///
/// @throws Error io           a file that cannot be read
/// @throws Error bad_format   a broken file of a supported format, with "file:line: "
/// @throws Error unsupported  another format, naming it where it is known and the supported ones
/// @cost   O(file)
PatchSet read_patches(const std::filesystem::path& path);

/// The same from the content of a file.
/// @param source  its name, for messages
PatchSet read_patches(std::string_view text, const std::string& source);

}  // namespace isopatch::geometry
