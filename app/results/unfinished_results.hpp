#pragma once

#include <filesystem>

namespace isopatch::app {

/// The results of a run on their way into a directory: its folder "unfinished".
///
/// A run writes into the folder and replaces the directory's results when everything is there, so that
/// earlier results stay whole until then, and a solution that was computed is not lost with a file that
/// cannot be written.
class UnfinishedResults {
 public:
  /// Clears what a run that was killed has left in the folder. The folder is made with the first file.
  explicit UnfinishedResults(std::filesystem::path directory);

  /// Where to write.
  const std::filesystem::path& folder() const { return folder_; }
  /// Removes the directory's results, moves the new ones there, the summary last, and removes the folder.
  /// @throws Error io
  void replace_earlier();
  /// Removes all but results.h5, from which the others can be made.
  /// @return  whether there is one; otherwise the folder is gone too
  bool keep_solution();

 private:
  std::filesystem::path directory_;
  std::filesystem::path folder_;
};

}  // namespace isopatch::app
