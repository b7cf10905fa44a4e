#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isopatch::test {

/// A file or folder of the data by others, which lie beside the project or where ISOPATCH_DATA says; it may
/// be absent.
inline std::filesystem::path data_file(const std::string& name) {
  const char* folder = std::getenv("ISOPATCH_DATA");
  return std::filesystem::path(folder != nullptr ? folder : ISOPATCH_SOURCE_DIR "/../shared/data") / name;
}

}  // namespace isopatch::test

/// Skips a test, by the file's name, where the file is absent: only for what is said of that very file.
#define ISOPATCH_NEEDS(path)          \
  if (!std::filesystem::exists(path)) \
  GTEST_SKIP() << "needs " << (path).string() << ", which is absent; ISOPATCH_DATA names the folder of data"
