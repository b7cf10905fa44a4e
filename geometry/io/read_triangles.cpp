#include "geometry/io/read_triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <vector>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/io/read_3mf.hpp"
#include "geometry/io/read_obj.hpp"
#include "geometry/io/read_off.hpp"
#include "geometry/io/read_ply.hpp"
#include "geometry/io/read_stl.hpp"
#include "geometry/mesh/polygon_triangles.hpp"

namespace isopatch::geometry {
namespace {

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

TriangleMesh triangles_of(const Polyhedron& polyhedron, const std::string& source) {
  TriangleMesh mesh;
  mesh.vertices = polyhedron.vertices;
  std::size_t count = 0;
  for (const auto& face : polyhedron.faces) count += face.size() - 2;
  mesh.triangles.resize(3, static_cast<Eigen::Index>(count));
  Eigen::Index next = 0;
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    try {
      const Eigen::Matrix3Xi part = polygon_triangles(mesh.vertices, polyhedron.faces[f]);
      mesh.triangles.middleCols(next, part.cols()) = part;
      next += part.cols();
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("{}: face {}: {}", source, f, error.what()));
    }
  }
  if (mesh.vertices.size() > 0)
    mesh.grain = mesh.vertices.cwiseAbs().maxCoeff() * std::numeric_limits<double>::epsilon();
  return mesh;
}

}  // namespace

bool is_triangle_file(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  return ending == ".stl" || ending == ".obj" || ending == ".ply" || ending == ".3mf";
}

MeasuredTriangles read_triangles(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path), source = path.string();
  if (!is_triangle_file(path) && ending != ".off")
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: triangles are read from .stl, .obj, .ply, .3mf and .off files", source));
  const std::string text = read_file(path);
  if (ending == ".3mf") return read_3mf(text, source);
  if (ending == ".stl") return {read_stl(text, source)};
  if (ending == ".obj") return {read_obj(text, source)};
  if (ending == ".ply") return {read_ply(text, source)};
  return {triangles_of(read_off(text, source), source)};
}

}  // namespace isopatch::geometry
