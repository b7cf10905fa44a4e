#pragma once

#include <cstdint>

namespace isopatch::solvers {

/// Bytes that this process can still take without swapping: what the machine has to spare, or less where a
/// control group (`control_group_memory`) or `ulimit -v` allows less; at least 1. 0 if nothing is known.
std::int64_t available_memory();

/// Bytes that this process holds now.
std::int64_t resident_memory();

}  // namespace isopatch::solvers
