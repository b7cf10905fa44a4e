#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isopatch::geometry::test {

/// A file of the data folder, which lies beside the project or where ISOPATCH_DATA says; it may be absent.
inline std::filesystem::path data_file(const std::string& name) {
  const char* folder = std::getenv("ISOPATCH_DATA");
  return (folder != nullptr ? std::filesystem::path(folder)
                            : std::filesystem::path(ISOPATCH_SOURCE_DIR) / "../shared/data") /
         name;
}

}  // namespace isopatch::geometry::test

/// Skips a test, by the file's name, where the file is absent.
#define ISOPATCH_NEEDS(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the data file is absent: " << (path)
