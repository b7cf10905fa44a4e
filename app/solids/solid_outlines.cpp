#include "app/solids/solid_outlines.hpp"

#include <optional>

#include "app/study/file_kind.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/tessellation.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "geometry/io/read_off.hpp"

namespace isopatch::app {
namespace {

using geometry::Brep;

std::optional<geometry::Tessellation> triangles_of(const Brep& brep) {
  try {
    return tessellate(brep, {.chord = 1e-3});
  } catch (const Error&) {
    return std::nullopt;  // an outline that crosses itself, say; its edges are drawn
  }
}

OutlinedSolid outlined(const Brep& brep) {
  OutlinedSolid solid;
  const auto mesh = triangles_of(brep);
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    solid.faces.push_back({brep.faces()[f].name, Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0)});
    if (!mesh) continue;
    solid.faces.back().points = mesh->faces[f].points;
    solid.faces.back().triangles = mesh->faces[f].triangles;
  }
  for (std::size_t e = 0; e < brep.edges().size(); ++e) {
    constexpr int pieces = 32;
    Eigen::Matrix3Xd line(3, pieces + 1);
    for (int i = 0; i <= pieces; ++i)
      line.col(i) = brep.point(EdgeId(static_cast<int>(e)), static_cast<double>(i) / pieces);
    solid.lines.push_back(std::move(line));
  }
  solid.edge_count = brep.edges().size();
  solid.vertex_count = static_cast<std::size_t>(brep.vertices().cols());
  const geometry::BoundaryReport boundary = geometry::boundary(edge_graph(brep));
  solid.boundary = boundary_fault(brep, boundary);
  solid.state = boundary_problem(brep, boundary);
  if (solid.state.empty()) solid.state = "closed";
  return solid;
}

/// Polygons by their sides and a fan of triangles.
OutlinedSolid outlined(const geometry::Polyhedron& polyhedron) {
  OutlinedSolid solid;
  for (const std::vector<int>& corners : polyhedron.faces) {
    OutlinedFace face{"", polyhedron.vertices(Eigen::all, corners), Eigen::Matrix3Xi(3, 0)};
    const auto n = static_cast<int>(corners.size());
    if (n > 2) face.triangles.resize(3, n - 2);
    for (int i = 0; i + 2 < n; ++i) face.triangles.col(i) << 0, i + 1, i + 2;
    Eigen::Matrix3Xd line(3, n + 1);
    line << face.points, face.points.col(0);
    solid.lines.push_back(std::move(line));
    solid.edge_count += static_cast<std::size_t>(n);
    solid.faces.push_back(std::move(face));
  }
  solid.edge_count /= 2;
  solid.vertex_count = static_cast<std::size_t>(polyhedron.vertices.cols());
  return solid;
}

/// Surfaces by their outlines.
OutlinedSolid outlined(const std::vector<std::optional<geometry::TrimmedSurface>>& surfaces, double metres) {
  OutlinedSolid solid;
  for (const auto& surface : surfaces) {
    solid.faces.push_back({"", Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0)});
    if (!surface) continue;
    solid.faces.back().name = surface->name;
    for (const auto& loop : surface->loops)
      for (const geometry::NurbsCurve& curve : loop) {
        constexpr int pieces = 32;
        Eigen::Matrix3Xd line(3, pieces + 1);
        const double low = curve.low()[0], high = curve.high()[0];
        for (int i = 0; i <= pieces; ++i) {
          const Eigen::Vector3d uv = curve.point(geometry::Parameter<1>(low + (high - low) * i / pieces));
          line.col(i) = metres * surface->surface.point(geometry::Parameter<2>(uv[0], uv[1]));
        }
        solid.lines.push_back(std::move(line));
        ++solid.edge_count;
      }
  }
  return solid;
}

/// What the file says, before anything is made of it.
std::vector<OutlinedSolid> as_written(const std::filesystem::path& path, double metres) {
  std::vector<OutlinedSolid> result;
  const FileKind kind = kind_of(path);
  if (kind == FileKind::polyhedra) {
    geometry::Polyhedron polyhedron = geometry::read_off(read_file(path), path.string());
    polyhedron.vertices *= metres;
    return {outlined(polyhedron)};
  }
  if (kind != FileKind::gismo_solids) return {{}};
  for (geometry::SolidBoundary& boundary : geometry::read_gismo_solids(read_file(path), path.string())) {
    boundary.corners.vertices *= metres;
    const bool has_surfaces = std::any_of(boundary.surfaces.begin(), boundary.surfaces.end(),
                                          [](const auto& surface) { return surface.has_value(); });
    result.push_back(has_surfaces ? outlined(boundary.surfaces, metres) : outlined(boundary.corners));
  }
  return result;
}

std::vector<OutlinedSolid> solids_of(const std::filesystem::path& path,
                                     const segmentation::BlockFiles& files) {
  std::string reason;
  try {
    geometry::ReadBrepOptions options = segmentation::block_reading(files);
    options.sew.accept_open = true;
    std::vector<OutlinedSolid> result;
    for (const geometry::BrepFile& body : geometry::read_breps(path, options).bodies) {
      result.push_back(outlined(body.brep));
      result.back().name = body.name;
    }
    return result;
  } catch (const Error& error) {
    reason = error.what();
  }
  std::vector<OutlinedSolid> result(1);
  try {
    result = as_written(path, files.length_unit.value_or(1));
  } catch (const Error&) {  // `reason` says it
  }
  for (OutlinedSolid& solid : result) {
    solid.state = reason;
    solid.name = path.stem().string();
  }
  return result;
}

}  // namespace

std::vector<OutlinedSolid> outlined_solids(const segmentation::BlockFiles& files) {
  std::vector<OutlinedSolid> result;
  segmentation::BlockNames names;
  for (const std::filesystem::path& path : files.files)
    for (OutlinedSolid& solid : solids_of(path, files)) {
      solid.name = names.add(solid.name);
      solid.file = path.filename().string();
      result.push_back(std::move(solid));
    }
  return result;
}

}  // namespace isopatch::app
