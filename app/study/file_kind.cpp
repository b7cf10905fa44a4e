#include "app/study/file_kind.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "geometry/io/read_triangles.hpp"

namespace isopatch::app {
namespace {

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

FileKind kind_of_xml(const std::filesystem::path& path) {
  try {
    return geometry::is_gismo_solid(read_file(path)) ? FileKind::gismo_solids : FileKind::patches;
  } catch (const Error&) {
    return FileKind::patches;
  }
}

FileKind kind_of_hdf5(const std::filesystem::path& path) {
  try {
    return geometry::Hdf5Reader(path).contains(blocks_group) ? FileKind::blocks : FileKind::results;
  } catch (const Error&) {
    return FileKind::results;
  }
}

}  // namespace

FileKind kind_of(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".toml") return FileKind::study;
  if (ending == ".h5") return kind_of_hdf5(path);
  if (ending == ".xml") return kind_of_xml(path);
  if (ending == ".g2" || ending == ".mesh") return FileKind::patches;
  if (ending == ".off") return FileKind::polyhedra;
  if (geometry::is_triangle_file(path)) return FileKind::triangles;
  return geometry::is_brep_file(path) ? FileKind::cad : FileKind::unknown;
}

bool holds_solids(FileKind kind) {
  return kind == FileKind::cad || kind == FileKind::gismo_solids || kind == FileKind::polyhedra;
}

}  // namespace isopatch::app
