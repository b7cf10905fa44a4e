#pragma once

#include <filesystem>

#include "geometry/brep/internal/cad_file.hpp"

namespace isopatch::geometry {

/// What `read_cad_file` gives, read in a child process, so that a file at which the library crashes, hangs or
/// wants too much memory is an error.
/// @throws Error bad_format as well  then
CadFile read_cad_file_guarded(const std::filesystem::path& path, BrepFormat format,
                              const ReadBrepOptions& options);

/// What the child does: the options and the file by its arguments, a CadFile as bytes on descriptor 3, phases
/// as lines.
/// @return  exit code
int cad_reader_main(int count, const char* const* arguments);

}  // namespace isopatch::geometry
