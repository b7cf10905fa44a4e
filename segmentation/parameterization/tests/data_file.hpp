#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isopatch::segmentation::test {

/// A file or folder of the data that is not part of this tree.
inline std::filesystem::path data_file(const std::string& name) {
  const char* folder = std::getenv("ISOPATCH_DATA");
  return std::filesystem::path(folder ? folder : ISOPATCH_SOURCE_DIR "/../shared/data") / name;
}

}  // namespace isopatch::segmentation::test

#define ISOPATCH_NEEDS(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs " << (path).string()
