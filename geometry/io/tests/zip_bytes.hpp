#pragma once

#include <zip.h>

#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>

#include "geometry/base/atomic_file.hpp"

namespace isopatch::geometry::test {

/// Files as a ZIP archive.
inline std::string zip_bytes(const std::map<std::string, std::string>& files) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("isopatch-" + std::to_string(::getpid()) + ".zip")).string();
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  for (const auto& [name, content] : files)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, content.data(), content.size(), 0),
                 ZIP_FL_OVERWRITE);
  zip_close(archive);
  const std::string bytes = read_file(path);
  std::filesystem::remove(path);
  return bytes;
}

}  // namespace isopatch::geometry::test
