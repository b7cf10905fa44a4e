#include "app/problem/block_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "app/base/provenance.hpp"
#include "app/study/file_kind.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/brep_bytes.hpp"
#include "geometry/io/hdf5_hex.hpp"

namespace isopatch::app {
namespace {

constexpr std::int64_t format_version = 1;

std::string at(const char* name) {
  return fmt::format("{}/{}", blocks_group, name);
}

/// Bytes as whole numbers of eight, before them how many there are: texts in HDF5 end at a zero.
void write_bytes(geometry::Hdf5Writer& file, const std::string& path, const std::string& bytes) {
  std::vector<std::int64_t> numbers(1 + (bytes.size() + 7) / 8, 0);
  numbers[0] = static_cast<std::int64_t>(bytes.size());
  if (!bytes.empty()) std::memcpy(&numbers[1], bytes.data(), bytes.size());
  file.write(path, numbers);
}

std::string read_bytes(const geometry::Hdf5Reader& file, const std::string& path) {
  const std::vector<std::int64_t> numbers = file.integers(path);
  const std::size_t room = numbers.empty() ? 0 : 8 * (numbers.size() - 1);
  const std::int64_t size = numbers.empty() ? -1 : numbers[0];
  if (size < 0 || static_cast<std::size_t>(size) > room)
    throw Error(ErrorCode::bad_format, fmt::format("'{}' has too few bytes", path));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (size > 0) std::memcpy(bytes.data(), &numbers[1], bytes.size());
  return bytes;
}

/// Texts one after the other, and their lengths.
void write_texts(geometry::Hdf5Writer& file, const std::string& path, const std::vector<std::string>& texts) {
  std::vector<std::int64_t> lengths;
  std::string all;
  for (const std::string& text : texts) {
    lengths.push_back(static_cast<std::int64_t>(text.size()));
    all += text;
  }
  file.write(path + "_lengths", lengths);
  write_bytes(file, path, all);
}

std::vector<std::string> read_texts(const geometry::Hdf5Reader& file, const std::string& path) {
  const std::string all = read_bytes(file, path);
  std::vector<std::string> texts;
  std::size_t begin = 0;
  for (const std::int64_t length : file.integers(path + "_lengths")) {
    if (length < 0 || static_cast<std::size_t>(length) > all.size() - begin)
      throw Error(ErrorCode::bad_format, fmt::format("'{}' has too few bytes", path));
    texts.push_back(all.substr(begin, static_cast<std::size_t>(length)));
    begin += static_cast<std::size_t>(length);
  }
  return texts;
}

segmentation::ReadBlocks blocks_in(const geometry::Hdf5Reader& file) {
  if (!file.contains(at("version")) || file.integer(at("version")) != format_version)
    throw Error(ErrorCode::bad_format, "holds no blocks of this version of isopatch");
  segmentation::ReadBlocks result;
  result.model.solids = geometry::bodies_from_bytes(read_bytes(file, at("shapes")));
  result.model.bodies = read_texts(file, at("bodies"));
  result.model.topology = read_hex_topology(file, at("topology"));
  result.model.faces = read_block_faces(file, at("sides"));
  result.warnings = read_texts(file, at("warnings"));
  validate(result.model);
  return result;
}

}  // namespace

std::string block_file_bytes(const segmentation::ReadBlocks& blocks) {
  geometry::Hdf5Writer file;
  file.write(at("version"), format_version);
  file.write(at("program"), fmt::format("isopatch {}", version()));
  write_bytes(file, at("shapes"), geometry::to_bytes(blocks.model.solids));
  write_texts(file, at("bodies"), blocks.model.bodies);
  write_hex_topology(file, at("topology"), blocks.model.topology);
  write_block_faces(file, at("sides"), blocks.model.faces);
  write_texts(file, at("warnings"), blocks.warnings);
  return file.image();
}

segmentation::ReadBlocks read_block_file(const std::filesystem::path& path) {
  const geometry::Hdf5Reader file(path);
  try {
    return blocks_in(file);
  } catch (const Error& error) {
    const std::string message = error.what();
    const bool named = message.find(path.string()) != message.npos;
    throw Error(ErrorCode::bad_format, fmt::format("{}{}; cut the solids again with `isopatch segment`",
                                                   named ? "" : path.string() + ": ", message));
  }
}

}  // namespace isopatch::app
