#include "geometry/base/error.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace isopatch {
namespace {

TEST(ErrorCode, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int code = 0; code <= static_cast<int>(ErrorCode::internal); ++code)
    EXPECT_TRUE(names.insert(name(static_cast<ErrorCode>(code))).second) << code;
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace isopatch
