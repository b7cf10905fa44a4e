#pragma once

#include <string>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/io/read_patches.hpp"

namespace isopatch::verification {

inline geometry::PatchSet reference_patches(const std::string& name) {
  return geometry::read_patches(test::data_file(name));
}

}  // namespace isopatch::verification

/// Skips a test whose data file is not there, with the reason that `isopatch verify` shows.
#define ISOPATCH_NEEDS_DATA(name) ISOPATCH_NEEDS(isopatch::test::data_file(name))
