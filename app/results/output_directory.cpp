#include "app/results/output_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/atomic_writer.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/unfinished_file.hpp"

namespace isopatch::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& directory, const std::string& reason) {
  throw Error(ErrorCode::io,
              fmt::format("cannot write to the output directory {}: {}; choose another one with --output DIR",
                          directory.string(), reason));
}

/// Makes a directory with its parents and says which had to be made, the outermost first.
std::vector<fs::path> make_directories(const fs::path& directory) {
  std::vector<fs::path> missing;
  std::error_code problem;
  for (fs::path path = fs::absolute(directory).lexically_normal(); !fs::exists(path, problem);
       path = path.parent_path()) {
    if (problem) refuse(directory, problem.message());
    missing.insert(missing.begin(), path);
  }
  for (const fs::path& path : missing) {
    fs::create_directory(path, problem);
    if (problem) refuse(directory, problem.message());
  }
  return missing;
}

/// Removes a file, and what a process that was killed has left of it.
void remove_written(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
  fs::remove(fs::path(file).concat(unfinished_ending), ignored);
}

/// Whether a run could have written it, or left it when it was killed: patch_000.vtu, exact_patches_001.vtu,
/// boundary_1234.vtu.unfinished.
bool is_field_file(std::string_view name) {
  if (name.ends_with(unfinished_ending)) name.remove_suffix(unfinished_ending.size());
  constexpr std::string_view tail = ".vtu";
  for (const std::string_view head : {"patch_", "patches_", "exact_patch_", "exact_patches_", "boundary_"}) {
    if (!name.starts_with(head) || !name.ends_with(tail) || name.size() < head.size() + tail.size() + 3)
      continue;
    const auto number = name.substr(head.size(), name.size() - head.size() - tail.size());
    if (number.find_first_not_of("0123456789") == std::string_view::npos) return true;
  }
  return false;
}

/// Removes those that are empty.
void remove_directories(const std::vector<fs::path>& made) {
  std::error_code ignored;
  for (std::size_t i = made.size(); i > 0; --i) fs::remove(made[i - 1], ignored);
}

/// Makes a directory and tries to write a file there.
/// @return  the directories that had to be made
std::vector<fs::path> made_writable(const fs::path& directory) {
  std::error_code problem;
  if (fs::exists(directory, problem) && !fs::is_directory(directory, problem))
    refuse(directory, "there is a file of that name");
  std::vector<fs::path> made = make_directories(directory);
  std::string probe = (directory / ".isopatch-XXXXXX").string();
  const int descriptor = ::mkstemp(probe.data());
  const int reason = errno;
  if (descriptor < 0) {
    remove_directories(made);
    refuse(directory, std::strerror(reason));
  }
  ::close(descriptor);
  ::unlink(probe.c_str());
  return made;
}

}  // namespace

void check_writable(const fs::path& directory) {
  remove_directories(made_writable(directory));
}

OutputFolder::OutputFolder(fs::path directory)
    : directory_(std::move(directory)), made_(made_writable(directory_)), removed_on_interrupt_(made_) {
  // The directory itself is the lock: it ends with the process, however that ends, and leaves no file. File
  // systems that know no locks let everybody in.
  descriptor_ = ::open(directory_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw Error(
      ErrorCode::io,
      fmt::format("another run writes to the output directory {}; wait until it is done, or choose another "
                  "directory with --output DIR",
                  directory_.string()));
}

OutputFolder::~OutputFolder() {
  if (descriptor_ >= 0) ::close(descriptor_);
  remove_directories(made_);
}

void remove_earlier_fields(const fs::path& directory) {
  std::error_code ignored;
  for (const char* collection : {"results.vtm", "results_boundaries.vtm", "results_exact.vtm"})
    remove_written(directory / collection);
  std::vector<fs::path> earlier;
  for (const auto& entry : fs::directory_iterator(directory / "fields", ignored))
    if (is_field_file(entry.path().filename().string())) earlier.push_back(entry.path());
  for (const fs::path& path : earlier) fs::remove(path, ignored);
  // Only goes if it is empty.
  fs::remove(directory / "fields", ignored);
}

void remove_earlier_results(const fs::path& directory) {
  std::error_code ignored;
  std::vector<fs::path> cases;
  for (const auto& entry : fs::directory_iterator(directory / case_folder, ignored))
    if (entry.is_directory()) cases.push_back(entry.path());
  remove_written(directory / "summary.json");
  remove_written(directory / "results.h5");
  remove_written(directory / "report.html");
  remove_earlier_fields(directory);
  for (const fs::path& of_case : cases) {
    remove_written(of_case / "report.html");
    remove_earlier_fields(of_case);
    fs::remove(of_case, ignored);
  }
  fs::remove(directory / case_folder, ignored);
}

void remove_earlier_modes(const fs::path& directory) {
  std::error_code ignored;
  remove_written(directory / "modes.json");
  std::vector<fs::path> shapes;
  for (const auto& entry : fs::directory_iterator(directory / modes_folder, ignored))
    if (entry.is_directory() &&
        entry.path().filename().string().find_first_not_of("0123456789") == std::string::npos)
      shapes.push_back(entry.path());
  for (const fs::path& shape : shapes) {
    remove_earlier_fields(shape);
    fs::remove(shape, ignored);
  }
  fs::remove(directory / modes_folder, ignored);
}

void remove_earlier_comparison(const fs::path& directory) {
  remove_written(directory / "compare.json");
  remove_written(directory / "compare.html");
}

void move_in(const fs::path& from, const fs::path& to, const fs::path& file) {
  make_directories((to / file).parent_path());
  std::error_code problem;
  fs::rename(from / file, to / file, problem);
  if (problem)
    throw Error(ErrorCode::io, fmt::format("cannot move {} to {}: {}", (from / file).string(),
                                           (to / file).string(), problem.message()));
}

void write_in(const fs::path& directory, const fs::path& file, std::string_view bytes) {
  make_directories((directory / file).parent_path());
  write_file(directory / file, bytes);
}

void write_in(const fs::path& directory, const fs::path& file,
              const std::function<void(const geometry::ByteSink&)>& content) {
  make_directories((directory / file).parent_path());
  AtomicWriter writer(directory / file);
  content([&](std::string_view bytes) { writer.write(bytes); });
  writer.finish();
}

void write_in_places(const fs::path& directory, const fs::path& file,
                     const std::function<void(const geometry::PlacedByteSink&)>& content) {
  make_directories((directory / file).parent_path());
  AtomicWriter writer(directory / file);
  content([&](std::uint64_t place, std::string_view bytes) { writer.write_at(place, bytes); });
  writer.finish();
}

}  // namespace isopatch::app
