#include "solvers/memory.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <string>

#include "solvers/control_group.hpp"

namespace isopatch::solvers {
namespace {

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

// Pages of this process: all that are mapped, and those in memory. Without allocating, for where nothing is
// left.
struct Pages {
  std::int64_t mapped = 0;
  std::int64_t resident = 0;
};

Pages pages() {
  Pages result;
  std::array<char, 128> text = {};
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return result;
  const ssize_t length = ::read(file, text.data(), text.size());
  ::close(file);
  if (length <= 0) return result;
  const char* const end = text.data() + length;
  const auto mapped = std::from_chars(text.data(), end, result.mapped);
  if (mapped.ptr < end) std::from_chars(mapped.ptr + 1, end, result.resident);
  return result;
}

std::int64_t machine() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  while (file >> word)
    if (std::int64_t kilobytes = 0; word == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  return unlimited;
}

std::int64_t address_space() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return static_cast<std::int64_t>(limit.rlim_cur) - pages().mapped * sysconf(_SC_PAGESIZE);
}

}  // namespace

std::int64_t available_memory() {
  const std::int64_t mappable = address_space();
  if (mappable <= 0) return 1;  // not enough to read any file
  const std::int64_t least = std::min({machine(), control_group_memory().value_or(unlimited), mappable});
  return least == unlimited ? 0 : std::max<std::int64_t>(least, 1);
}

std::int64_t resident_memory() {
  return pages().resident * sysconf(_SC_PAGESIZE);
}

}  // namespace isopatch::solvers
