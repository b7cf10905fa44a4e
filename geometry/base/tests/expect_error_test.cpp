#include "geometry/base/tests/expect_error.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace isopatch {
namespace {

int read(int line) {
  if (line > 3) throw Error(ErrorCode::bad_format, "line 4 is too long");
  return line;
}

TEST(ExpectError, HoldsForTheCauseAndTheWords) {
  EXPECT_ERROR(read(4), ErrorCode::bad_format, "line 4");
}

TEST(ExpectError, FailsForWhatElseHappens) {
  EXPECT_NONFATAL_FAILURE(EXPECT_ERROR(read(3), ErrorCode::bad_format, "line"), "no error");
  EXPECT_NONFATAL_FAILURE(EXPECT_ERROR(read(4), ErrorCode::internal, "line"),
                          "bad_format: line 4 is too long");
  EXPECT_NONFATAL_FAILURE(EXPECT_ERROR(read(4), ErrorCode::bad_format, "line 5"), "line 4 is too long");
  EXPECT_NONFATAL_FAILURE(EXPECT_ERROR(read(4), ErrorCode::bad_format, ""), "line 4 is too long");
}

TEST(ExpectError, TellsTheCauseFromAWordOfTheMessage) {
  EXPECT_NONFATAL_FAILURE(EXPECT_ERROR(read(4), ErrorCode::bad_format, "bad_format"), "line 4 is too long");
}

}  // namespace
}  // namespace isopatch
