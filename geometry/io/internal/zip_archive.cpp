#include "geometry/io/internal/zip_archive.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

constexpr std::uint64_t most_bytes = 1'000'000'000;

std::string reason_of(const zip_error_t& error) {
  zip_error_t copy = error;
  return zip_error_strerror(&copy);
}

}  // namespace

void ZipArchive::Closed::operator()(zip* archive) const {
  zip_discard(archive);
}

ZipArchive::ZipArchive(std::string_view bytes, std::string source) : source_(std::move(source)) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* memory = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (memory != nullptr) archive_.reset(zip_open_from_source(memory, ZIP_RDONLY, &error));
  const std::string reason = archive_ ? "" : reason_of(error);
  if (!archive_ && memory != nullptr) zip_source_free(memory);
  zip_error_fini(&error);
  if (!archive_)
    throw Error(ErrorCode::bad_format, fmt::format("{}: no ZIP archive can be read: {}", source_, reason));
}

bool ZipArchive::contains(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
}

std::string ZipArchive::content(const std::string& name) const {
  zip_stat_t found;
  zip_stat_init(&found);
  if (zip_stat(archive_.get(), name.c_str(), 0, &found) != 0 || (found.valid & ZIP_STAT_SIZE) == 0)
    throw Error(ErrorCode::bad_format, fmt::format("{}: the package has no part '{}'", source_, name));
  if (found.size > most_bytes)
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: the part '{}' has {} bytes, more than 1 GB", source_, name, found.size));
  if ((found.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && found.encryption_method != ZIP_EM_NONE)
    throw Error(ErrorCode::unsupported, fmt::format("{}: the part '{}' is encrypted", source_, name));
  zip_file_t* file = zip_fopen(archive_.get(), name.c_str(), 0);
  if (file == nullptr)
    throw Error(ErrorCode::bad_format, fmt::format("{}: the part '{}' cannot be unpacked: {}", source_, name,
                                                   zip_strerror(archive_.get())));
  // Grows as it is unpacked: the size that is written down may be wrong.
  std::string content;
  std::string piece(1 << 16, '\0');
  zip_int64_t count = 0;
  while (content.size() <= found.size && (count = zip_fread(file, piece.data(), piece.size())) > 0)
    content.append(piece.data(), static_cast<std::size_t>(count));
  const bool damaged = count < 0 || content.size() != found.size;
  zip_fclose(file);
  if (damaged) throw Error(ErrorCode::bad_format, fmt::format("{}: the part '{}' is damaged", source_, name));
  return content;
}

}  // namespace isopatch::geometry
