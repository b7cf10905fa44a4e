#pragma once

#include <filesystem>

namespace isopatch {

/// A new folder among the system's temporary files; removed with all in it when the object is destroyed.
class TemporaryFolder {
 public:
  /// @throws Error io  the system makes none
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace isopatch
