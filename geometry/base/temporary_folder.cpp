#include "geometry/base/temporary_folder.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "geometry/base/error.hpp"

namespace isopatch {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "isopatch-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw Error(ErrorCode::io, "cannot make a folder in " + std::filesystem::temp_directory_path().string());
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace isopatch
