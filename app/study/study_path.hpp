#pragma once

#include <filesystem>
#include <string>

#include "app/study/config_value.hpp"

namespace isopatch::app {

/// "${NAME}" and "${NAME:-default}" replaced by environment variables.
/// @throws Error invalid_argument for a variable that is not set and has no default, or a bracket left open
std::string expand_variables(const std::string& text);

/// A path that a study gives, its variables expanded; relative ones count from the study's folder.
/// @param place   of the path, with which errors begin
/// @param source  path of the study
/// @throws Error invalid_argument as `expand_variables`, and for an empty path
std::filesystem::path study_path(const std::string& path, const Place& place, const std::string& source);

}  // namespace isopatch::app
