#pragma once

#include <cstdint>
#include <string_view>

namespace isopatch::app {

/// Version of the program.
std::string_view version();

/// Most memory that this process has held so far, from the operating system.
std::int64_t peak_memory_bytes();

}  // namespace isopatch::app
