#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/study.hpp"

namespace isopatch::app {

/// Reads a study.
///
/// @param text         TOML
/// @param source_name  its path: messages name it, relative paths are resolved against its folder
/// @param overrides    "key=value" as in `with_override`, applied in order
/// @throws Error bad_format        broken TOML, with file, line and column
/// @throws Error invalid_argument  unknown keys (naming the nearest known one), wrong types, units and
///                                 ranges, missing keys, with file, line and column
Study parse_study(const std::string& text, const std::filesystem::path& source_name,
                  const std::vector<std::string>& overrides = {});

/// Reads a study's file. @throws Error io as well
Study read_study(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

}  // namespace isopatch::app
