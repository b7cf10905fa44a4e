#pragma once

#include <string_view>

namespace isopatch {

/// Ending of the temporary file in which `write_file` and `AtomicWriter` gather what is to appear whole. Only
/// a process that is killed leaves one.
inline constexpr std::string_view unfinished_ending = ".unfinished";

}  // namespace isopatch
