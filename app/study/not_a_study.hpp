#pragma once

#include <filesystem>
#include <string_view>

namespace isopatch::app {

/// Refuses what is given as a study and is a model or results, saying which command takes it.
/// @param text  the file's content
/// @throws Error invalid_argument
void refuse_what_is_no_study(const std::filesystem::path& path, std::string_view text);

}  // namespace isopatch::app
