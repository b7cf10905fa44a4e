#pragma once

#include <filesystem>

namespace isopatch {

/// A folder in which files gather until all are there. While it lives, SIGINT and SIGTERM after
/// `remove_unfinished_files_on_interrupt()` remove the folder if it is empty, and otherwise say what is in
/// it. One at a time.
class GatheringFolder {
 public:
  explicit GatheringFolder(const std::filesystem::path& folder);
  ~GatheringFolder();
  GatheringFolder(const GatheringFolder&) = delete;
  GatheringFolder& operator=(const GatheringFolder&) = delete;
};

}  // namespace isopatch
