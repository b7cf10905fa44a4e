#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "geometry/io/read_patches.hpp"

namespace isopatch::verification {

/// Path of a file of test data by others, which may be absent: see ISOPATCH_DATA in CONTRIBUTING.md.
inline std::filesystem::path data_path(const std::string& name) {
  const char* folder = std::getenv("ISOPATCH_DATA");
  return (folder ? std::filesystem::path(folder)
                 : std::filesystem::path(ISOPATCH_SOURCE_DIR) / "../shared/data") /
         name;
}

inline geometry::PatchSet reference_patches(const std::string& name) {
  return geometry::read_patches(data_path(name));
}

}  // namespace isopatch::verification

/// Skips a test whose data file is not there, with the reason that `isopatch verify` shows.
#define ISOPATCH_NEEDS_DATA(name)                                          \
  if (!std::filesystem::exists(isopatch::verification::data_path(name)))   \
  GTEST_SKIP() << "needs " << (name) << ", and the folder of such files, " \
               << isopatch::verification::data_path("").string() << ", does not have it; set ISOPATCH_DATA"
