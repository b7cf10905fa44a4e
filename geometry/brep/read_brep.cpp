#include "geometry/brep/read_brep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/internal/cad_file.hpp"
#include "geometry/brep/internal/file_format.hpp"
#include "geometry/brep/internal/guarded_cad_file.hpp"
#include "geometry/brep/internal/sentences.hpp"
#include "geometry/brep/make_brep.hpp"
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

BrepSet from_module(const fs::path& path, BrepFormat format, const ReadBrepOptions& options) {
  CadFile file = read_cad_file_guarded(path, format, options);
  BrepSet result{{}, std::move(file.missing), std::move(file.warnings), std::move(file.unit)};
  for (KernelSolid& solid : file.bodies)
    result.bodies.push_back({Brep(std::move(solid.kernel)), std::move(solid.name), solid.largest_correction});
  return result;
}

TrimmedSurface scaled(const TrimmedSurface& surface, double metres) {
  TrimmedSurface result = surface;
  result.surface = NurbsSurface(surface.surface.knots(), metres * surface.surface.control_points(),
                                surface.surface.weights());
  return result;
}

std::string unit_taken(const ReadBrepOptions& options) {
  return options.length_unit ? "as given" : "m, since the format states none";
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
    return {make_brep(corners, options.sew), "", 0};
  }
  if (given < static_cast<std::ptrdiff_t>(boundary.surfaces.size()))
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: {} of {} faces have surfaces; give them to all faces or to none", source,
                            given, boundary.surfaces.size()));
  std::vector<TrimmedSurface> faces;
  for (const auto& surface : boundary.surfaces) faces.push_back(scaled(*surface, metres));
  SewnBrep sewn = sew(faces, options.sew);
  return {std::move(sewn.brep), "", sewn.largest_correction};
}

BrepSet from_gismo(const fs::path& path, const ReadBrepOptions& options) {
  BrepSet result{{}, {}, {}, unit_taken(options)};
  const std::string text = read_file(path);
  if (!is_gismo_solid(text))
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: no Solid and no TrimSurface in the file; volume patches need no solid",
                            path.string()));
  for (const SolidBoundary& boundary : read_gismo_solids(text, path.string()))
    result.bodies.push_back(from_boundary(boundary, path.string(), options));
  return result;
}

BrepSet from_off(const fs::path& path, const ReadBrepOptions& options) {
  Polyhedron polyhedron = read_off(read_file(path), path.string());
  polyhedron.vertices *= options.length_unit.value_or(1);
  return {{{make_brep(polyhedron, options.sew), "", 0}}, {}, {}, unit_taken(options)};
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

BrepSet read(const fs::path& path, const ReadBrepOptions& options) {
  const std::string end = file_ending(path);
  read_file(path);  // says why, if it cannot
  if (const auto format = module_format(end)) return from_module(path, *format, options);
  if (end == ".xml") return from_gismo(path, options);
  if (end == ".off") return from_off(path, options);
  throw Error(ErrorCode::unsupported,
              fmt::format("{}: solids are read from {}", path.string(), brep_formats));
}

/// Every body gets a name of its own.
void set_names(std::vector<BrepFile>& bodies, const std::string& fallback) {
  std::map<std::string, int> count;
  for (BrepFile& body : bodies) {
    if (body.name.empty()) body.name = fallback;
    const int before = count[body.name]++;
    if (before > 0) body.name += fmt::format("#{}", before);
  }
}

/// What could not be read is a warning or an error.
void require_all(BrepSet& set, const ReadBrepOptions& options) {
  if (set.missing.empty()) return;
  const std::string what = fmt::format("not all of the file could be read: {}", listed(set.missing));
  if (!options.allow_partial)
    throw Error(ErrorCode::bad_format,
                fmt::format("{}. Mend the file, or take what is left: --allow-partial (in a study, "
                            "[model] allow_partial = true)",
                            what));
  set.warnings.push_back(what);
  set.missing.clear();
}

/// Bodies that are not closed are left out with a warning, or refused.
void require_solids(BrepSet& set, const ReadBrepOptions& options) {
  std::vector<BrepFile> solids;
  for (BrepFile& body : set.bodies) try {
      require_solid(body.brep);
      solids.push_back(std::move(body));
    } catch (const SolidError& error) {
      const std::string message =
          set.bodies.size() > 1 ? fmt::format("body '{}': {}", body.name, error.what()) : error.what();
      if (!options.allow_partial) throw SolidError(error.code(), message, of_solid(error.fault(), body.name));
      set.warnings.push_back(message + "; it is left out");
    }
  if (solids.empty())
    throw Error(ErrorCode::not_manifold,
                fmt::format("no body of the file is closed: {}", set.warnings.back()));
  set.bodies = std::move(solids);
}

}  // namespace

bool is_brep_file(const fs::path& path) {
  const std::string end = file_ending(path);
  return module_format(end).has_value() || end == ".off";
}

BrepSet read_breps(const fs::path& path, const ReadBrepOptions& options) {
  check(options);
  return named(path, [&] {
    BrepSet set = read(path, options);
    set_names(set.bodies, path.stem().string());
    if (options.allow_partial || !options.sew.accept_open) require_all(set, options);
    if (!options.sew.accept_open) require_solids(set, options);
    return set;
  });
}

BrepFile read_brep(const fs::path& path, const ReadBrepOptions& options) {
  std::vector<BrepFile> solids = read_breps(path, options).bodies;
  if (solids.size() == 1) return std::move(solids.front());
  std::string names;
  for (std::size_t i = 0; i < solids.size(); ++i)
    names += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, solids[i].name);
  throw Error(ErrorCode::unsupported,
              fmt::format("{}: {} solids ({}) where one is expected", path.string(), solids.size(), names));
}

}  // namespace isopatch::geometry
