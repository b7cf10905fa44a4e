#pragma once

#include <filesystem>
#include <string>

namespace isopatch::geometry {

/// Where a part of isopatch is that is not linked to the program: beside the program, in the library folder
/// beside the program's, where isopatch was installed, where it was built.
/// @throws Error unsupported  it is missing
std::filesystem::path installed_part(const std::string& name);

}  // namespace isopatch::geometry
