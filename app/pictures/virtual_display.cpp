#include "app/pictures/virtual_display.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <sstream>

#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr const char* advice =
    "install the Debian package xvfb (apt-get install xvfb) and try again; 'scripts/run render ...' does "
    "both, and "
    "where only xvfb-run is at hand, 'xvfb-run -a isopatch render ...' draws";

/// The program's full path, or "" if no folder of PATH has it.
std::string find_program(const char* name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string candidate = folder + "/" + name;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return "";
}

/// In the new process: becomes Xvfb, which writes its number to `pipe`. Calls nothing that takes a lock.
[[noreturn]] void become_server(const char* program, char* const* arguments, int parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::setpgid(0, 0);  // Ctrl-C is for the parent, which takes the server with it
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  if (::getppid() != parent) ::_exit(1);
  const int nowhere = ::open("/dev/null", O_RDWR);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::execv(program, arguments);
  ::_exit(127);
}

/// The line that comes out of a pipe; empty if it closes or nothing has come in half a minute.
std::string line_from(int pipe) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(30);
  std::string text;
  while (text.find('\n') == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waiting = {pipe, POLLIN, 0};
    const int ready = left > 0 ? ::poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return "";
    char bytes[64];
    const auto count = ::read(pipe, bytes, sizeof(bytes));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return "";
    text.append(bytes, static_cast<std::size_t>(count));
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
  const std::string program = find_program("Xvfb");
  if (program.empty())
    throw Error(ErrorCode::unsupported,
                fmt::format("pictures are drawn through an X display, and there is none: {}", advice));
  int ends[2];
  if (::pipe(ends) != 0) throw Error(ErrorCode::io, "no pipe to talk to Xvfb: too many open files");
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  std::string descriptor = std::to_string(ends[1]);
  std::string words[] = {"Xvfb",       "-displayfd", descriptor, "-screen", "0",
                         "640x480x24", "-nolisten",  "tcp",      "-noreset"};
  char* arguments[std::size(words) + 1] = {};
  for (std::size_t i = 0; i < std::size(words); ++i) arguments[i] = words[i].data();
  const int parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become_server(program.c_str(), arguments, parent);
  ::close(ends[1]);
  const std::string number = process_ > 0 ? line_from(ends[0]) : "";
  ::close(ends[0]);
  if (!number.empty()) {
    name_ = ":" + number;
    return;
  }
  stop();
  throw Error(
      ErrorCode::unsupported,
      fmt::format("{} does not start, and pictures need its display; see what 'Xvfb -displayfd 1' says",
                  program));
}

VirtualDisplay::~VirtualDisplay() {
  stop();
}

void VirtualDisplay::stop() {
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

}  // namespace isopatch::app
