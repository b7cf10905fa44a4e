#pragma once

#include <cstdlib>
#include <filesystem>

namespace isopatch::verification {

/// A file of the reference data, found through ISOPATCH_DATA or beside the project.
inline std::filesystem::path reference_data(const std::filesystem::path& name) {
  const char* folder = std::getenv("ISOPATCH_DATA");
  return (folder ? std::filesystem::path(folder) : std::filesystem::path(ISOPATCH_SOURCE_DIR) / "../shared/data") / name;
}

}  // namespace isopatch::verification

/// Skips the test by name where a file of other people's data is not at hand.
#define ISOPATCH_NEED_DATA(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "not run, no such file: " << path.string()
