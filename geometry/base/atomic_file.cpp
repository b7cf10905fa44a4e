#include "geometry/base/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <mutex>
#include <sstream>
#include <string>

#include "geometry/base/atomic_writer.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/gathering_folder.hpp"
#include "geometry/base/made_folders.hpp"
#include "geometry/base/unfinished_file.hpp"

namespace isopatch {
namespace {

// The temporary file now being written. One file is written at a time, so one slot is enough; a plain
// array because a signal handler may touch nothing else.
std::mutex writing;
char unfinished[4096];
std::atomic<bool> has_unfinished{false};

// The folder in which whole files gather, and whether there is one; as above.
char gathering[4096];
std::atomic<bool> has_gathering{false};

// Folders that were made, the innermost first, each name with a 0 behind it, and the characters of all.
char made[8192];
std::atomic<std::size_t> made_size{0};

void say(const char* text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

// Calls nothing but what a signal handler may.
void remove_and_exit(int signal) {
  if (has_unfinished) ::unlink(unfinished);
  // A folder goes if nothing is in it.
  if (has_gathering && ::rmdir(gathering) != 0 && errno != ENOENT) {
    say("\ninterrupted: the files that were whole by then are in ");
    say(gathering);
    say("; the next run there removes them\n");
  } else {
    say("\ninterrupted: nothing half-written was left behind\n");
  }
  for (std::size_t at = 0; at < made_size; at += std::strlen(made + at) + 1) ::rmdir(made + at);
  ::_exit(128 + signal);
}

[[noreturn]] void fail(const char* verb, const std::filesystem::path& path, int reason) {
  const char* advice = reason == ENOSPC || reason == EFBIG || reason == EDQUOT
                           ? "; free some space or choose another output directory"
                           : "";
  throw Error(ErrorCode::io,
              fmt::format("cannot {} {}: {}{}", verb, path.string(), std::strerror(reason), advice));
}

/// Interrupts wait as long as it lives.
class WithoutInterrupts {
 public:
  WithoutInterrupts() {
    ::sigset_t interrupts;
    ::sigemptyset(&interrupts);
    ::sigaddset(&interrupts, SIGINT);
    ::sigaddset(&interrupts, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &interrupts, &before_);
  }
  ~WithoutInterrupts() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutInterrupts(const WithoutInterrupts&) = delete;

 private:
  ::sigset_t before_ = {};
};

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target), path_(target.string().append(unfinished_ending)) {
    if (path_.size() + 1 > sizeof(unfinished)) fail("write", target_, ENAMETOOLONG);
    std::memcpy(unfinished, path_.c_str(), path_.size() + 1);
    {
      const WithoutInterrupts together;
      while (!take()) {
      }
      has_unfinished = true;
    }
    if (::ftruncate(descriptor_, 0) != 0) give_up();
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (has_unfinished) ::unlink(path_.c_str());
    has_unfinished = false;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ::ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) give_up();
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void write_at(std::uint64_t place, std::string_view bytes) {
    while (!bytes.empty()) {
      const ::ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<::off_t>(place));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) give_up();
      bytes.remove_prefix(static_cast<std::size_t>(count));
      place += static_cast<std::uint64_t>(count);
    }
  }
  void finish() {
    if (::fsync(descriptor_) != 0 && errno != EINVAL) give_up();
    // Closed after it has its name: the lock must not end while the file can be taken for a left one.
    if (::rename(path_.c_str(), target_.c_str()) != 0) give_up();
    has_unfinished = false;
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) give_up();
  }

 private:
  // Opens the file, which a killed process may have left, and locks it against other processes.
  // @return  whether it is still the one of that name
  bool take() {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) give_up();
    if (descriptor_ <= STDERR_FILENO) {  // closed by the caller: messages must not go into the file
      const int low = descriptor_;
      descriptor_ = ::fcntl(low, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
      ::close(low);
      if (descriptor_ < 0) give_up();
    }
    // File systems that know no locks let everybody in.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw Error(ErrorCode::io,
                  fmt::format("cannot write {}: another process is writing it; wait until it is "
                              "done, or choose another name",
                              target_.string()));
    }
    struct stat mine = {};
    struct stat named = {};
    if (::fstat(descriptor_, &mine) != 0) give_up();
    if (::stat(path_.c_str(), &named) == 0 && mine.st_dev == named.st_dev && mine.st_ino == named.st_ino)
      return true;
    ::close(descriptor_);
    descriptor_ = -1;
    return false;
  }
  [[noreturn]] void give_up() { fail("write", target_, errno); }
  std::filesystem::path target_;
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace

GatheringFolder::GatheringFolder(const std::filesystem::path& folder) {
  const std::string path = folder.string();
  if (path.size() + 1 > sizeof(gathering)) return;
  has_gathering = false;
  std::memcpy(gathering, path.c_str(), path.size() + 1);
  has_gathering = true;
}

GatheringFolder::~GatheringFolder() {
  has_gathering = false;
}

MadeFolders::MadeFolders(const std::vector<std::filesystem::path>& folders) {
  made_size = 0;
  std::size_t size = 0;
  for (std::size_t i = folders.size(); i > 0; --i) {
    const std::string path = folders[i - 1].string();
    if (size + path.size() + 1 > sizeof(made)) break;
    std::memcpy(made + size, path.c_str(), path.size() + 1);
    size += path.size() + 1;
  }
  made_size = size;
}

MadeFolders::~MadeFolders() {
  made_size = 0;
}

struct AtomicWriter::State {
  explicit State(const std::filesystem::path& path) : lock(writing), file(path) {}
  std::lock_guard<std::mutex> lock;
  TemporaryFile file;
};

AtomicWriter::AtomicWriter(const std::filesystem::path& path) {
  // A file-size limit then shows as an error of write() instead of ending the process.
  std::signal(SIGXFSZ, SIG_IGN);
  state_ = std::make_unique<State>(path);
}

AtomicWriter::~AtomicWriter() = default;

void AtomicWriter::write(std::string_view bytes) {
  state_->file.write(bytes);
}

void AtomicWriter::write_at(std::uint64_t place, std::string_view bytes) {
  state_->file.write_at(place, bytes);
}

void AtomicWriter::finish() {
  state_->file.finish();
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  AtomicWriter file(path);
  file.write(bytes);
  file.finish();
}

void remove_unfinished_files_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = remove_and_exit;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

std::string read_file(const std::filesystem::path& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) fail("read", path, errno);
  if (S_ISDIR(status.st_mode)) fail("read", path, EISDIR);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("read", path, errno);
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) fail("read", path, errno ? errno : EIO);
  return std::move(content).str();
}

}  // namespace isopatch
