#pragma once

#include <filesystem>
#include <vector>

namespace isopatch {

/// Folders that were made for what is to come. While it lives, SIGINT and SIGTERM after
/// `remove_unfinished_files_on_interrupt()` remove those that are empty. One at a time.
class MadeFolders {
 public:
  /// @param folders  the outermost first
  explicit MadeFolders(const std::vector<std::filesystem::path>& folders);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
};

}  // namespace isopatch
