#include "app/problem/read_model_file.hpp"

#include <fmt/format.h>

#include "app/study/file_kind.hpp"
#include "geometry/base/error.hpp"
#include "geometry/io/read_patches.hpp"

namespace isopatch::app {

geometry::PatchSet read_model_file(const std::filesystem::path& path, bool solids_too) {
  if (solids_too && kind_of(path) == FileKind::triangles)
    throw Error(
        ErrorCode::unsupported,
        fmt::format(
            "{} holds triangles; a solid is made of them by isopatch reconstruct, and by isopatch segment "
            "and isopatch run on the way",
            path.string()));
  try {
    return geometry::read_patches(path);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::unsupported || !solids_too) throw;
    throw Error(
        error.code(),
        fmt::format(
            "{}. Formats of solids: STEP (.step, .stp, .p21), IGES (.iges, .igs), OpenCASCADE "
            "(.brep, .brp), G+Smo XML with Solid elements (.xml), polyhedra (.off); of triangles: STL "
            "(.stl), Wavefront (.obj), PLY (.ply), 3MF (.3mf)",
            error.what()));
  }
}

}  // namespace isopatch::app
