#include "app/problem/block_file.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "app/base/provenance.hpp"
#include "app/problem/stored_texts.hpp"
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
