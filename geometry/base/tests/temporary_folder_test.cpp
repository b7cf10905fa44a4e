#include "geometry/base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsItsOwnAndGoesWithWhatIsInIt) {
  std::optional<TemporaryFolder> first(std::in_place);
  const TemporaryFolder second;
  EXPECT_NE(first->path(), second.path());
  fs::create_directory(first->path() / "inner");
  std::ofstream(first->path() / "inner" / "file") << "text";
  const fs::path was = first->path();
  first.reset();
  EXPECT_FALSE(fs::exists(was));
  EXPECT_TRUE(fs::is_directory(second.path()));
}

TEST(TemporaryFolder, SaysWhereNoneCanBeMade) {
  const TemporaryFolder place;
  const char* known = std::getenv("TMPDIR");
  const std::string before = known ? known : "";
  // Even root makes no folder in /proc.
  ASSERT_EQ(::setenv("TMPDIR", "/proc", 1), 0);
  EXPECT_ERROR(TemporaryFolder(), ErrorCode::io, "/proc");
  known ? ::setenv("TMPDIR", before.c_str(), 1) : ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace isopatch
