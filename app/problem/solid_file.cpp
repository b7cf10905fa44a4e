#include "app/problem/solid_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "app/problem/stored_texts.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/brep_bytes.hpp"

namespace isopatch::app {
namespace {

const std::string solids_group = "/isopatch_solids";

std::vector<std::int64_t> numbers_of(const Eigen::Matrix3Xi& triangles) {
  return {triangles.data(), triangles.data() + triangles.size()};
}

void write_triangles(geometry::Hdf5Writer& file, const std::string& group, const SolidTriangles& made) {
  file.write(group + "/vertices", made.mesh.vertices);
  file.write(group + "/grain", made.mesh.grain);
  file.write(group + "/deviation", made.deviation);
  file.write(group + "/triangles", numbers_of(made.mesh.triangles));
  file.write(group + "/faces", std::vector<std::int64_t>(made.faces.begin(), made.faces.end()));
  write_texts(file, group + "/solid", {made.solid});
}

SolidTriangles read_triangles_of(const geometry::Hdf5Reader& file, const std::string& group) {
  SolidTriangles made;
  made.mesh.vertices = file.matrix(group + "/vertices", 3);
  made.mesh.grain = file.number(group + "/grain");
  made.deviation = file.number(group + "/deviation");
  const std::vector<std::int64_t> corners = file.integers(group + "/triangles");
  const std::vector<std::int64_t> faces = file.integers(group + "/faces");
  if (corners.size() != 3 * faces.size())
    throw Error(ErrorCode::bad_format,
                fmt::format("'{}' has {} corners of {} triangles", group, corners.size(), faces.size()));
  made.mesh.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] < 0 || corners[i] >= made.mesh.vertices.cols())
      throw Error(ErrorCode::bad_format, fmt::format("'{}' names vertex {}", group, corners[i]));
    made.mesh.triangles.data()[i] = static_cast<int>(corners[i]);
  }
  made.faces.assign(faces.begin(), faces.end());
  const std::vector<std::string> names = read_texts(file, group + "/solid");
  if (names.size() == 1) made.solid = names.front();
  return made;
}

}  // namespace

std::string solid_file_bytes(const FoundSolids& solids) {
  geometry::Hdf5Writer file;
  write_bytes(file, solids_group + "/shapes", geometry::to_bytes(solids.read.solids));
  write_texts(file, solids_group + "/warnings", solids.read.warnings);
  file.write(solids_group + "/meshes", static_cast<std::int64_t>(solids.triangles.size()));
  for (std::size_t i = 0; i < solids.triangles.size(); ++i)
    write_triangles(file, fmt::format("{}/mesh_{}", solids_group, i), solids.triangles[i]);
  return file.image();
}

FoundSolids read_solid_file(const std::filesystem::path& path) {
  const geometry::Hdf5Reader file(path);
  FoundSolids result;
  result.read.solids = geometry::bodies_from_bytes(read_bytes(file, solids_group + "/shapes"));
  result.read.warnings = read_texts(file, solids_group + "/warnings");
  const std::int64_t meshes = file.integer(solids_group + "/meshes");
  for (std::int64_t i = 0; i < meshes; ++i)
    result.triangles.push_back(read_triangles_of(file, fmt::format("{}/mesh_{}", solids_group, i)));
  return result;
}

}  // namespace isopatch::app
