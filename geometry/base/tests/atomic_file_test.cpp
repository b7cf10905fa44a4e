#include "geometry/base/atomic_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "geometry/base/atomic_writer.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/gathering_folder.hpp"

namespace isopatch {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "isopatch-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
    path_ = directory_ / "result.json";
  }
  void TearDown() override {
    std::error_code ignored;
    fs::permissions(directory_, fs::perms::owner_all, ignored);
    fs::remove_all(directory_, ignored);
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory_)) names.push_back(entry.path().filename());
    return names;
  }
  fs::path directory_;
  fs::path path_;
};

std::string io_error(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    return error.what();
  }
  return "no error";
}

// Runs `act` in a child process and returns its exit status as waitpid gives it.
int in_child(const std::function<int()>& act) {
  const ::pid_t child = ::fork();
  if (child == 0) ::_exit(act());
  int status = -1;
  ::waitpid(child, &status, 0);
  return status;
}

TEST_F(AtomicFile, RoundTripKeepsEveryByte) {
  std::string bytes(100'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31 % 256);
  write_file(path_, bytes);
  EXPECT_EQ(read_file(path_), bytes);
  write_file(path_, "");
  EXPECT_EQ(read_file(path_), "");
}

TEST_F(AtomicFile, ReplacesTheWholeFileAndLeavesNothingElse) {
  write_file(path_, "a long first version");
  write_file(path_, "short");
  EXPECT_EQ(read_file(path_), "short");
  EXPECT_THAT(files(), testing::ElementsAre("result.json"));
}

TEST_F(AtomicFile, WhatAKilledRunLeftBehindIsOverwritten) {
  std::ofstream(directory_ / "result.json.unfinished") << "a long part of an earlier result";
  write_file(path_, "short");
  EXPECT_EQ(read_file(path_), "short");
  EXPECT_THAT(files(), testing::ElementsAre("result.json"));
}

TEST_F(AtomicFile, AFileThatAnotherProcessIsWritingIsRefused) {
  write_file(path_, "old");
  const std::string unfinished = (directory_ / "result.json.unfinished").string();
  const int other = ::open(unfinished.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  ASSERT_EQ(::write(other, "half", 4), 4);
  EXPECT_THAT(io_error([&] { write_file(path_, "new"); }),
              AllOf(HasSubstr(path_.string()), HasSubstr("another process is writing it")));
  EXPECT_EQ(read_file(path_), "old");
  EXPECT_EQ(read_file(unfinished), "half") << "that of the other one stays as it is";
  ::close(other);
  write_file(path_, "new");
  EXPECT_EQ(read_file(path_), "new");
  EXPECT_THAT(files(), testing::ElementsAre("result.json"));
}

TEST_F(AtomicFile, MissingDirectoryIsNamed) {
  const fs::path path = directory_ / "none" / "result.json";
  EXPECT_THAT(io_error([&] { write_file(path, "x"); }),
              AllOf(HasSubstr(path.string()), HasSubstr("No such file")));
}

TEST_F(AtomicFile, ADirectoryInTheWayIsAnErrorAndLeavesNothing) {
  fs::create_directory(path_);
  EXPECT_THAT(io_error([&] { write_file(path_, "x"); }),
              AllOf(HasSubstr("cannot write"), HasSubstr("directory")));
  EXPECT_THAT(files(), testing::ElementsAre("result.json"));
}

TEST_F(AtomicFile, UnwritableDirectoryIsAnErrorAndKeepsTheOldFile) {
  write_file(path_, "old");
  fs::permissions(directory_, fs::perms::owner_read | fs::perms::owner_exec);
  // Permissions do not bind root, so the child becomes nobody where it may.
  constexpr ::uid_t nobody = 65534;
  const int status = in_child([&] {
    if (::geteuid() == 0 && (::chmod(directory_.c_str(), 0555) != 0 || ::setuid(nobody) != 0)) return 2;
    const std::string message = io_error([&] { write_file(path_, "new"); });
    return message.find("Permission denied") != std::string::npos ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read_file(path_), "old");
}

TEST_F(AtomicFile, AFullDiskIsAnErrorWithAdviceAndKeepsTheOldFile) {
  write_file(path_, "old");
  const int status = in_child([&] {
    const ::rlimit limit = {4096, 4096};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 2;
    const std::string message = io_error([&] { write_file(path_, std::string(10'000, 'x')); });
    return message.find("free some space") != std::string::npos ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read_file(path_), "old");
  EXPECT_THAT(files(), testing::ElementsAre("result.json"));
}

// Starts a child that writes the file again and again, and sends it a signal some time after the first.
int interrupted_writer(const fs::path& path, const std::string& bytes, int signal) {
  fs::remove(path);
  const ::pid_t child = ::fork();
  if (child == 0) {
    ::close(STDERR_FILENO);
    remove_unfinished_files_on_interrupt();
    while (true) write_file(path, bytes);
  }
  while (!fs::exists(path)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(15));
  ::kill(child, signal);
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(AtomicFile, AnInterruptLeavesNoUnfinishedFile) {
  const std::string bytes(1 << 20, 'x');
  for (const int signal : {SIGINT, SIGTERM, SIGINT, SIGINT}) {
    EXPECT_EQ(interrupted_writer(path_, bytes, signal), 128 + signal);
    EXPECT_THAT(files(), testing::ElementsAre("result.json"));
    EXPECT_EQ(read_file(path_).size(), bytes.size());
  }
}

// What a child says that is interrupted while files gather in a folder.
std::string said_when_interrupted(const fs::path& folder, const fs::path& said) {
  const ::pid_t child = ::fork();
  if (child == 0) {
    if (std::freopen(said.c_str(), "w", stderr) == nullptr) ::_exit(1);
    remove_unfinished_files_on_interrupt();
    const GatheringFolder gathering(folder);
    ::raise(SIGTERM);
    ::_exit(2);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM);
  return read_file(said);
}

TEST_F(AtomicFile, AnInterruptSaysWhatIsWholeAndLeavesNoEmptyFolder) {
  const fs::path folder = directory_ / "unfinished", said = directory_ / "said.txt";
  EXPECT_THAT(said_when_interrupted(folder, said), HasSubstr("nothing half-written"));
  fs::create_directory(folder);
  EXPECT_THAT(said_when_interrupted(folder, said), HasSubstr("nothing half-written"));
  EXPECT_FALSE(fs::exists(folder));
  fs::create_directory(folder);
  write_file(folder / "results.h5", "whole");
  EXPECT_THAT(said_when_interrupted(folder, said), HasSubstr("are in " + folder.string() + ";"));
  EXPECT_EQ(read_file(folder / "results.h5"), "whole");
}

TEST_F(AtomicFile, ReadingAMissingFileNamesIt) {
  EXPECT_THAT(io_error([&] { read_file(path_); }),
              AllOf(HasSubstr(path_.string()), HasSubstr("No such file")));
}

TEST_F(AtomicFile, ReadingADirectorySaysSo) {
  EXPECT_THAT(io_error([&] { read_file(directory_); }), HasSubstr("Is a directory"));
}

TEST_F(AtomicFile, WrittenInPiecesAppearsWhenFinished) {
  write_file(path_, "before");
  {
    AtomicWriter writer(path_);
    writer.write("one, ");
    EXPECT_EQ(read_file(path_), "before");
    writer.write("two");
    writer.finish();
  }
  EXPECT_EQ(read_file(path_), "one, two");
  EXPECT_EQ(files().size(), 1u);
}

TEST_F(AtomicFile, PiecesMayBeWrittenInAnyOrder) {
  AtomicWriter writer(path_);
  writer.write_at(5, "two");
  writer.write("one");
  writer.write_at(3, ", ");
  writer.write("; ");
  writer.finish();
  EXPECT_EQ(read_file(path_), "one; two");
}

TEST_F(AtomicFile, LeftUnfinishedChangesNothing) {
  write_file(path_, "before");
  try {
    AtomicWriter writer(path_);
    writer.write("half");
    throw std::runtime_error("in between");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(read_file(path_), "before");
  EXPECT_EQ(files().size(), 1u);
}

}  // namespace
}  // namespace isopatch
