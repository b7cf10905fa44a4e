#pragma once

#include <filesystem>
#include <string_view>

namespace isopatch {

/// Writes a file whole or not at all: the bytes go to a temporary file beside it, which is synchronised
/// and renamed. On failure, and on SIGINT or SIGTERM after `remove_unfinished_files_on_interrupt()`, the
/// temporary file is removed and an earlier file of that name is left as it was.
///
/// @throws Error io, with the path and the system's reason (no such directory, no space left, ...)
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes Ctrl-C (and SIGTERM) end the process at once with code 130 (143), without a partial file.
void remove_unfinished_files_on_interrupt();

/// Reads a file whole.
/// @throws Error io, naming the path and the reason; also for a directory
std::string read_file(const std::filesystem::path& path);

}  // namespace isopatch
