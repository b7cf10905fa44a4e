#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace isopatch::solvers {

/// Bytes that this process can still take before a control group (of a batch job, a container, a service)
/// stops it: the least that is left on the way from the process's own group to the root, of version 1 and 2.
///
/// What is left is the limit less the use, of which files that nobody uses any more do not count: the system
/// drops them first. Version 2's `memory.high`, above which a group is slowed down, counts as a limit.
///
/// @param root  where proc and the mount points of the groups are; another folder for tests
/// @return      nothing without a limit; 0 or less if a group is full
std::optional<std::int64_t> control_group_memory(const std::filesystem::path& root = "/");

}  // namespace isopatch::solvers
