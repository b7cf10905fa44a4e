#pragma once

#include <memory>
#include <string>
#include <string_view>

// For the .cpp files of this folder only.

struct zip;

namespace isopatch::geometry {

/// A ZIP archive in memory, which must outlive it.
class ZipArchive {
 public:
  /// @throws Error bad_format  no archive, or a damaged one
  ZipArchive(std::string_view bytes, std::string source);

  bool contains(const std::string& name) const;
  /// A file's content, unpacked and held against its checksum.
  /// @throws Error bad_format   it is missing or damaged
  /// @throws Error unsupported  it is encrypted, or larger than 1 GB
  std::string content(const std::string& name) const;

 private:
  struct Closed {
    void operator()(zip* archive) const;
  };
  std::string source_;
  std::unique_ptr<zip, Closed> archive_;
};

}  // namespace isopatch::geometry
