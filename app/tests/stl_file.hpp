#pragma once

#include <filesystem>
#include <string>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/io/read_stl.hpp"

namespace isopatch::app::test {

/// Writes the triangles of a made solid in millimetres as SOLID.stl.
/// @return  its path
inline std::string stl_file(const std::filesystem::path& folder, const std::string& solid) {
  const geometry::Tessellation parts = geometry::tessellate(geometry::test::made_brep(solid));
  geometry::TriangleMesh mesh;
  for (const geometry::FaceTriangles& part : parts.faces) {
    const Eigen::Index points = mesh.vertices.cols(), triangles = mesh.triangles.cols();
    mesh.vertices.conservativeResize(3, points + part.points.cols());
    mesh.vertices.rightCols(part.points.cols()) = 1000 * part.points;
    mesh.triangles.conservativeResize(3, triangles + part.triangles.cols());
    mesh.triangles.rightCols(part.triangles.cols()) = part.triangles.array() + static_cast<int>(points);
  }
  const std::string file = (folder / (solid + ".stl")).string();
  write_file(file, geometry::to_stl(mesh));
  return file;
}

}  // namespace isopatch::app::test
