#include "solvers/control_group.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace isopatch::solvers {
namespace {

namespace fs = std::filesystem;

// Names of the files that say how much memory a group may take and takes.
struct Version {
  std::vector<std::string> limits;
  std::string used;
  std::string dropped;  // key in memory.stat of what the system can drop
};
const Version version_1{{"memory.limit_in_bytes"}, "memory.usage_in_bytes", "total_inactive_file"};
const Version version_2{{"memory.max", "memory.high"}, "memory.current", "inactive_file"};

// Where a tree of groups is mounted: the group `group` is seen as the folder `folder`.
struct Mount {
  const Version* version;
  std::string group;
  std::string folder;
};

// The number in a file that holds nothing else; "max" and absent files give none.
std::optional<std::int64_t> number_in(const fs::path& path) {
  std::ifstream file(path);
  std::int64_t value = 0;
  if (file >> value) return value;
  return std::nullopt;
}

// A number by its name in a file of lines "name number"; 0 without it.
std::int64_t entry_in(const fs::path& path, const std::string& name) {
  std::ifstream file(path);
  std::string word;
  for (std::int64_t value = 0; file >> word >> value;)
    if (word == name) return value;
  return 0;
}

bool has_word(const std::string& list, const std::string& word) {
  return ("," + list + ",").find("," + word + ",") != std::string::npos;
}

// Blanks and backslashes are octal numbers in mountinfo: "\040".
std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape =
        text[i] == '\\' && i + 3 < text.size() && text.find_first_not_of("01234567", i + 1) > i + 3;
    result += escape ? static_cast<char>(std::stoi(text.substr(i + 1, 3), nullptr, 8)) : text[i];
    if (escape) i += 3;
  }
  return result;
}

// A line of mountinfo: id, parent, device, root, point, options, any number of fields, "-", type, source,
// options of the type.
std::optional<Mount> mount_of(const std::string& line) {
  std::istringstream words(line);
  std::string skipped, group, folder, type, options;
  words >> skipped >> skipped >> skipped >> group >> folder;
  while (words >> skipped && skipped != "-") {
  }
  words >> type >> skipped >> options;
  if (type == "cgroup2") return Mount{&version_2, unescaped(group), unescaped(folder)};
  if (type == "cgroup" && has_word(options, "memory"))
    return Mount{&version_1, unescaped(group), unescaped(folder)};
  return std::nullopt;
}

std::vector<Mount> mounts(const fs::path& root) {
  std::vector<Mount> result;
  std::ifstream file(root / "proc/self/mountinfo");
  for (std::string line; std::getline(file, line);)
    if (const auto mount = mount_of(line)) result.push_back(*mount);
  return result;
}

// The process's own group in the tree of a version: a line "number:controllers:group", of version 2
// "0::group".
std::optional<std::string> own_group(const fs::path& root, const Version& version) {
  std::ifstream file(root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool meant = &version == &version_2 ? line.starts_with("0::") : has_word(controllers, "memory");
    if (meant) return line.substr(second + 1);
  }
  return std::nullopt;
}

// The path of a group below the mounted one; "" where it is not below, as a container may see it.
fs::path below(const std::string& group, const std::string& mounted) {
  const std::string start = mounted == "/" ? "" : mounted;
  if (!group.starts_with(start) || group.find("/..") != std::string::npos) return {};
  const std::string rest = group.substr(start.size());
  return rest.empty() || rest.front() != '/' ? fs::path{} : fs::path(rest.substr(1));
}

// What is left of one group.
std::optional<std::int64_t> left_in(const fs::path& folder, const Version& version) {
  constexpr std::int64_t unlimited = std::int64_t{1} << 60;  // version 1 writes a number near 2^63
  std::optional<std::int64_t> least;
  for (const std::string& name : version.limits) {
    const std::optional<std::int64_t> limit = number_in(folder / name);
    if (limit && *limit < unlimited) least = std::min(*limit, least.value_or(unlimited));
  }
  if (!least) return std::nullopt;
  const std::int64_t used = number_in(folder / version.used).value_or(0);
  return *least - std::max<std::int64_t>(0, used - entry_in(folder / "memory.stat", version.dropped));
}

}  // namespace

std::optional<std::int64_t> control_group_memory(const fs::path& root) {
  std::optional<std::int64_t> least;
  for (const Mount& mount : mounts(root)) {
    const std::optional<std::string> group = own_group(root, *mount.version);
    if (!group) continue;
    fs::path path = below(*group, mount.group);
    while (true) {
      const fs::path folder = root / fs::path(mount.folder).relative_path() / path;
      const std::optional<std::int64_t> left = left_in(folder, *mount.version);
      if (left) least = std::min(*left, least.value_or(*left));
      if (path.empty()) break;
      path = path.parent_path();
    }
  }
  return least;
}

}  // namespace isopatch::solvers
