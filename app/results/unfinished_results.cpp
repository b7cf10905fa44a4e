#include "app/results/unfinished_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/results/output_directory.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

namespace fs = std::filesystem;

/// Files of a folder and below, relative to it, with the voucher last.
std::vector<fs::path> files_of(const fs::path& folder, const char* voucher) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  std::sort(files.begin(), files.end());
  std::stable_partition(files.begin(), files.end(), [&](const fs::path& f) { return f != voucher; });
  return files;
}

}  // namespace

const ResultKind run_results{"unfinished", "summary.json", "results.h5", remove_earlier_results};
const ResultKind modes_results{"unfinished_modes", "modes.json", "modes.json", remove_earlier_modes};

UnfinishedResults::UnfinishedResults(const ResultKind& kind, fs::path directory)
    : kind_(&kind), directory_(std::move(directory)), folder_(directory_ / kind.folder), gathering_(folder_) {
  kind_->remove(folder_);
}

void UnfinishedResults::replace_earlier() {
  kind_->remove(directory_);
  for (const fs::path& file : files_of(folder_, kind_->voucher)) move_in(folder_, directory_, file);
  std::error_code ignored;
  kind_->remove(folder_);  // folders that are empty now
  fs::remove(folder_, ignored);
}

bool UnfinishedResults::keep_essence() {
  std::error_code ignored;
  const fs::path essence = folder_ / kind_->essence;
  const fs::path aside = folder_ / "aside";
  fs::rename(essence, aside, ignored);
  kind_->remove(folder_);
  fs::rename(aside, essence, ignored);
  fs::remove(folder_, ignored);
  return fs::exists(essence, ignored);
}

}  // namespace isopatch::app
