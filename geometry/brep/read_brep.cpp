#include "geometry/brep/read_brep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/internal/file_format.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "geometry/io/read_off.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;

void check(const ReadBrepOptions& options) {
  if (options.length_unit && !(*options.length_unit > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("length_unit is {}; it must be positive", *options.length_unit));
  validate(options.sew);
}

std::vector<BrepFile> from_module(const fs::path& path, BrepFormat format, const ReadBrepOptions& options) {
  if (format != BrepFormat::brep && options.length_unit)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: the file states its unit of length; leave length_unit out", path.string()));
  read_file(path);  // says why, if it cannot
  std::vector<BrepFile> result;
  for (KernelSolid& solid : brep_module().read(path, format, options.length_unit.value_or(1), options.sew))
    result.push_back({Brep(std::move(solid.kernel)), std::move(solid.name), solid.largest_correction});
  return result;
}

TrimmedSurface scaled(const TrimmedSurface& surface, double metres) {
  TrimmedSurface result = surface;
  result.surface = NurbsSurface(surface.surface.knots(), metres * surface.surface.control_points(),
                                surface.surface.weights());
  return result;
}

// As many faces have surfaces, none or all; corners make the rest.
BrepFile from_boundary(const SolidBoundary& boundary, const std::string& source,
                       const ReadBrepOptions& options) {
  const double metres = options.length_unit.value_or(1);
  const auto given = std::count_if(boundary.surfaces.begin(), boundary.surfaces.end(),
                                   [](const auto& surface) { return surface.has_value(); });
  if (given == 0) {
    Polyhedron corners = boundary.corners;
    corners.vertices *= metres;
    return {make_brep(corners, options.sew), boundary.name, 0};
  }
  if (given < static_cast<std::ptrdiff_t>(boundary.surfaces.size()))
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: {} of {} faces have surfaces; give them to all faces or to none", source,
                            given, boundary.surfaces.size()));
  std::vector<TrimmedSurface> faces;
  for (const auto& surface : boundary.surfaces) faces.push_back(scaled(*surface, metres));
  SewnBrep sewn = sew(faces, options.sew);
  return {std::move(sewn.brep), boundary.name, sewn.largest_correction};
}

std::vector<BrepFile> from_gismo(const fs::path& path, const ReadBrepOptions& options) {
  std::vector<BrepFile> result;
  const std::string text = read_file(path);
  if (!is_gismo_solid(text))
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: no Solid and no TrimSurface in the file; volume patches need no solid",
                            path.string()));
  for (const SolidBoundary& boundary : read_gismo_solids(text, path.string()))
    result.push_back(from_boundary(boundary, path.string(), options));
  return result;
}

std::vector<BrepFile> from_off(const fs::path& path, const ReadBrepOptions& options) {
  Polyhedron polyhedron = read_off(read_file(path), path.string());
  polyhedron.vertices *= options.length_unit.value_or(1);
  return {{make_brep(polyhedron, options.sew), "", 0}};
}

// Errors of the making of solids get the file's name in front, if they lack it.
template <class Make>
auto named(const fs::path& path, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    const std::string message = error.what();
    if (message.find(path.string()) != message.npos) throw;
    const std::string text = fmt::format("{}: {}", path.string(), message);
    if (const auto* placed = dynamic_cast<const SolidError*>(&error))
      throw SolidError(error.code(), text, placed->fault());
    throw Error(error.code(), text);
  }
}

std::vector<BrepFile> read(const fs::path& path, const ReadBrepOptions& options) {
  const std::string end = file_ending(path);
  if (const auto format = module_format(end)) return from_module(path, *format, options);
  if (end == ".xml") return from_gismo(path, options);
  if (end == ".off") return from_off(path, options);
  throw Error(ErrorCode::unsupported,
              fmt::format("{}: solids are read from .step, .stp, .iges, .igs, .brep, .xml (G+Smo) and .off",
                          path.string()));
}

}  // namespace

bool is_brep_file(const fs::path& path) {
  const std::string end = file_ending(path);
  return module_format(end).has_value() || end == ".off";
}

std::vector<BrepFile> read_breps(const fs::path& path, const ReadBrepOptions& options) {
  check(options);
  return named(path, [&] {
    std::vector<BrepFile> solids = read(path, options);
    if (!options.sew.accept_open)
      for (const BrepFile& solid : solids) require_solid(solid.brep);
    return solids;
  });
}

BrepFile read_brep(const fs::path& path, const ReadBrepOptions& options) {
  std::vector<BrepFile> solids = read_breps(path, options);
  if (solids.size() == 1) return std::move(solids.front());
  std::string names;
  for (std::size_t i = 0; i < solids.size(); ++i)
    names += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, solids[i].name);
  throw Error(ErrorCode::unsupported,
              fmt::format("{}: {} solids ({}) where one is expected", path.string(), solids.size(), names));
}

}  // namespace isopatch::geometry
