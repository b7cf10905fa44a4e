#pragma once

#include <filesystem>

#include "geometry/base/gathering_folder.hpp"

namespace isopatch::app {

/// The files that one command writes into a directory.
struct ResultKind {
  const char* folder;   ///< of the directory, in which they are made
  const char* voucher;  ///< the file that vouches for the others
  const char* essence;  ///< the file that is kept if others cannot be written
  void (*remove)(const std::filesystem::path& directory);
};

/// Of `isopatch run`.
extern const ResultKind run_results;
/// Of `isopatch modes`.
extern const ResultKind modes_results;

/// Results on their way into a directory, in a folder of it.
///
/// A command writes into the folder and replaces the directory's results when everything is there, so that
/// earlier results stay whole until then, and what was computed is not lost with a file that cannot be
/// written.
class UnfinishedResults {
 public:
  /// Clears what a run that was killed has left in the folder. The folder is made with the first file.
  UnfinishedResults(const ResultKind& kind, std::filesystem::path directory);

  /// Where to write.
  const std::filesystem::path& folder() const { return folder_; }
  /// Removes the directory's results, moves the new ones there, the voucher last, and removes the folder.
  /// @throws Error io
  void replace_earlier();
  /// Removes all but the essence.
  /// @return  whether there is one; otherwise the folder is gone too
  bool keep_essence();

 private:
  const ResultKind* kind_;
  std::filesystem::path directory_;
  std::filesystem::path folder_;
  GatheringFolder gathering_;
};

}  // namespace isopatch::app
