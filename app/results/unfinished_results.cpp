#include "app/results/unfinished_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/results/output_directory.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

namespace fs = std::filesystem;

/// Files of a folder and below, relative to it, with the summary last.
std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  std::sort(files.begin(), files.end());
  std::stable_partition(files.begin(), files.end(), [](const fs::path& f) { return f != "summary.json"; });
  return files;
}

}  // namespace

UnfinishedResults::UnfinishedResults(fs::path directory)
    : directory_(std::move(directory)), folder_(directory_ / "unfinished") {
  remove_earlier_results(folder_);
}

void UnfinishedResults::replace_earlier() {
  remove_earlier_results(directory_);
  for (const fs::path& file : files_of(folder_)) move_in(folder_, directory_, file);
  std::error_code ignored;
  remove_earlier_results(folder_);  // folders that are empty now
  fs::remove(folder_, ignored);
}

bool UnfinishedResults::keep_solution() {
  std::error_code ignored;
  const fs::path solution = folder_ / "results.h5";
  const fs::path aside = folder_ / "solution";
  fs::rename(solution, aside, ignored);
  remove_earlier_results(folder_);
  fs::rename(aside, solution, ignored);
  fs::remove(folder_, ignored);
  return fs::exists(solution, ignored);
}

}  // namespace isopatch::app
