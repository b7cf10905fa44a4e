#include "geometry/base/guarded_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_errors = 4000;
constexpr int result_descriptor = 3;
/// A busy machine gives a program a share of a core only.
constexpr double patience = 5;

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorCode::io, fmt::format("{}: {}", what, std::strerror(errno)));
}

/// A file descriptor that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// Memory that looks like a file.
Descriptor memory_file(std::string_view content) {
  Descriptor file(::memfd_create("isopatch", MFD_CLOEXEC));
  if (file.number() < 0) fail("memory for another process");
  while (!content.empty()) {
    const ::ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && errno != EINTR) fail("memory for another process");
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  ::lseek(file.number(), 0, SEEK_SET);
  return file;
}

std::string content_of(const Descriptor& file) {
  const ::off_t size = ::lseek(file.number(), 0, SEEK_END);
  ::lseek(file.number(), 0, SEEK_SET);
  std::string result(static_cast<std::size_t>(std::max<::off_t>(size, 0)), '\0');
  std::size_t got = 0;
  while (got < result.size()) {
    const ::ssize_t n = ::read(file.number(), result.data() + got, result.size() - got);
    if (n <= 0 && errno != EINTR) break;
    if (n > 0) got += static_cast<std::size_t>(n);
  }
  result.resize(got);
  return result;
}

struct Pipe {
  Descriptor out, in;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("a pipe to another process");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// What the new process needs; prepared before, since nothing may be allocated between fork and exec.
struct Prepared {
  std::vector<const char*> arguments;
  std::array<int, 4> descriptors;  ///< that become 0 to 3
  ::rlimit processor, memory, core;
  ::pid_t parent;
};

// Only calls that are safe after fork in a program with threads.
[[noreturn]] void become(const Prepared& prepared) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != prepared.parent) ::_exit(127);
  std::array<int, 4> high{};
  for (std::size_t i = 0; i < 4; ++i) high[i] = ::fcntl(prepared.descriptors[i], F_DUPFD, 10);
  for (std::size_t i = 0; i < 4; ++i) ::dup2(high[i], static_cast<int>(i));
  ::close_range(result_descriptor + 1, ~0U, 0);
  ::setrlimit(RLIMIT_CPU, &prepared.processor);
  ::setrlimit(RLIMIT_AS, &prepared.memory);
  ::setrlimit(RLIMIT_CORE, &prepared.core);
  ::sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGSEGV, SIGFPE, SIGABRT, SIGBUS, SIGXCPU})
    ::signal(signal, SIG_DFL);
  ::execv(prepared.arguments[0], const_cast<char* const*>(prepared.arguments.data()));
  const int why = errno;
  [[maybe_unused]] const auto written = ::write(result_descriptor, &why, sizeof why);
  ::_exit(127);
}

/// @param more  until the limit can no longer be caught
::rlimit limit(double value, double more = 0) {
  return {static_cast<::rlim_t>(value), static_cast<::rlim_t>(value + more)};
}

/// Hands lines on as they come in.
class Lines {
 public:
  explicit Lines(const std::function<void(std::string_view)>& on_line) : on_line_(on_line) {}
  void add(std::string_view bytes) {
    rest_ += bytes;
    std::size_t from = 0;
    for (std::size_t end = 0; (end = rest_.find('\n', from)) != rest_.npos; from = end + 1)
      if (on_line_) on_line_(std::string_view(rest_).substr(from, end - from));
    rest_.erase(0, from);
  }

 private:
  const std::function<void(std::string_view)>& on_line_;
  std::string rest_;
};

/// Reads what is there; false at the end.
bool drain(Descriptor& from, const std::function<void(std::string_view)>& take) {
  std::array<char, 1 << 14> buffer{};
  const ::ssize_t n = ::read(from.number(), buffer.data(), buffer.size());
  if (n < 0 && errno == EINTR) return true;
  if (n <= 0) return false;
  take({buffer.data(), static_cast<std::size_t>(n)});
  return true;
}

/// A process that is ended and waited for, also if the caller leaves by an exception.
class Child {
 public:
  explicit Child(::pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (id_ > 0) wait_after(SIGKILL);
  }
  bool is_over() {
    if (id_ > 0 && ::waitpid(id_, &status_, WNOHANG) == id_) id_ = -1;
    return id_ < 0;
  }
  void wait_after(int signal) {
    ::kill(id_, signal);
    while (::waitpid(id_, &status_, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
  }
  int status() const { return status_; }

 private:
  ::pid_t id_;
  int status_ = 0;
};

/// Listens until the process is over or the time is up; whether it was over by itself.
bool listen(Child& child, Pipe& output, Pipe& errors, const GuardedCommand& command,
            std::string& error_text) {
  Lines lines(command.on_line);
  const auto until = Clock::now() + std::chrono::duration<double>(patience * command.limits.seconds);
  const auto add_errors = [&](std::string_view bytes) {
    error_text += bytes;
    if (error_text.size() > most_errors) error_text.erase(0, error_text.size() - most_errors);
  };
  bool hears_output = true, hears_errors = true;
  while (hears_output || hears_errors || !child.is_over()) {
    std::array<::pollfd, 2> polled{{{hears_output ? output.out.number() : -1, POLLIN, 0},
                                    {hears_errors ? errors.out.number() : -1, POLLIN, 0}}};
    constexpr int step = 20;  // ms, for a process that has closed its streams
    ::poll(polled.data(), polled.size(), hears_output || hears_errors ? 200 : step);
    if (polled[0].revents != 0)
      hears_output = drain(output.out, [&](std::string_view bytes) { lines.add(bytes); });
    if (polled[1].revents != 0) hears_errors = drain(errors.out, add_errors);
    if (Clock::now() < until) continue;
    if (!child.is_over()) child.wait_after(SIGKILL);
    return false;
  }
  return true;
}

std::string signal_text(int signal) {
  const char* name = ::strsignal(signal);
  return fmt::format("signal {} ({})", signal, name == nullptr ? "unknown" : name);
}

}  // namespace

std::string GuardedOutcome::text(const GuardLimits& limits) const {
  switch (end) {
    case End::timed_out:
      return fmt::format("was stopped after {:.6g} s", limits.seconds);
    case End::signalled:
      return fmt::format("ended by {}", signal_text(code));
    case End::exited:
      break;
  }
  return fmt::format("ended with code {}", code);
}

GuardedOutcome run_guarded(const GuardedCommand& command) {
  if (!(command.limits.seconds > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the time limit is {} s; it must be positive", command.limits.seconds));
  const Descriptor input = memory_file(command.input), result = memory_file("");
  Pipe output = make_pipe(), errors = make_pipe();
  Prepared prepared{};
  const std::string program = command.program.string();
  prepared.arguments.push_back(program.c_str());
  for (const std::string& argument : command.arguments) prepared.arguments.push_back(argument.c_str());
  prepared.arguments.push_back(nullptr);
  prepared.descriptors = {input.number(), output.in.number(), errors.in.number(), result.number()};
  prepared.processor = limit(std::ceil(command.limits.seconds), 5);
  prepared.memory =
      command.limits.bytes > 0 ? limit(double(command.limits.bytes)) : ::rlimit{RLIM_INFINITY, RLIM_INFINITY};
  prepared.core = limit(0);
  prepared.parent = ::getpid();
  const ::pid_t id = ::fork();
  if (id < 0) fail(fmt::format("{} cannot be started", program));
  if (id == 0) become(prepared);
  Child child(id);
  output.in.close();
  errors.in.close();
  GuardedOutcome outcome;
  const bool by_itself = listen(child, output, errors, command, outcome.errors);
  outcome.result = content_of(result);
  const int status = child.status();
  if (!by_itself || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU))) {
    outcome.end = GuardedOutcome::End::timed_out;
  } else if (WIFSIGNALED(status)) {
    outcome.end = GuardedOutcome::End::signalled;
    outcome.code = WTERMSIG(status);
  } else {
    outcome.code = WEXITSTATUS(status);
    if (outcome.code == 127 && outcome.result.size() == sizeof(int)) {
      std::memcpy(&errno, outcome.result.data(), sizeof(int));
      fail(fmt::format("{} cannot be started", program));
    }
  }
  return outcome;
}

}  // namespace isopatch
