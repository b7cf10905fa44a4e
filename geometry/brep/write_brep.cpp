#include "geometry/brep/write_brep.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/internal/file_format.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "geometry/io/read_off.hpp"
#include "geometry/io/write_gismo_solid.hpp"
#include "geometry/topology/edge_graph.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;

/// A folder for files of the library, which cannot write into memory; removed at the end.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(fs::temp_directory_path() / fmt::format("isopatch-solid-{}-{}", ::getpid(), ++count)) {
    fs::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code none;
    fs::remove_all(path_, none);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  static inline int count = 0;
  fs::path path_;
};

double metres(const std::string& unit) {
  if (unit == "m") return 1;
  if (unit == "mm") return 1e-3;
  if (unit == "in") return 0.0254;
  throw Error(ErrorCode::invalid_argument, fmt::format("unit is '{}'; mm, m and in are supported", unit));
}

std::string off_text(const Brep& brep, double scale) {
  for (std::size_t e = 0; e < brep.edges().size(); ++e)
    if (brep.edges()[e].kind != CurveKind::line)
      throw Error(ErrorCode::unsupported, fmt::format("{} is no straight line, as a polyhedron needs",
                                                      describe(brep, EdgeId(static_cast<int>(e)))));
  Polyhedron polyhedron = corners(brep);
  polyhedron.vertices *= scale;
  return to_off(polyhedron);
}

std::string gismo_text(const Brep& brep, double scale) {
  SolidBoundary boundary;
  const EdgeGraph graph = edge_graph(brep);
  boundary.corners.vertices = scale * brep.vertices();
  for (TrimmedSurface& face : trimmed_surfaces(brep)) {
    const NurbsSurface& surface = face.surface;
    face.surface = NurbsSurface(surface.knots(), scale * surface.control_points(), surface.weights());
    boundary.surfaces.emplace_back(std::move(face));
  }
  for (const EdgeGraph::Face& face : graph.faces) {
    std::vector<int> around;
    for (const VertexId vertex : corners(graph, face.loops.front())) around.push_back(vertex.value);
    boundary.corners.faces.push_back(std::move(around));
  }
  return to_gismo_solid(boundary);
}

std::string module_text(const Brep& brep, const fs::path& path, BrepFormat format, const std::string& unit) {
  const ScratchFolder scratch;
  const fs::path written = scratch.path() / path.filename();
  brep_module().write(written, format, brep.kernel(), unit);
  return read_file(written);
}

}  // namespace

void write_brep(const fs::path& path, const Brep& brep, const WriteBrepOptions& options) {
  const double scale = 1 / metres(options.unit);
  const std::string ending = file_ending(path);
  if (const auto format = module_format(ending))
    write_file(path, module_text(brep, path, *format, options.unit));
  else if (ending == ".off")
    write_file(path, off_text(brep, scale));
  else if (ending == ".xml")
    write_file(path, gismo_text(brep, scale));
  else
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: solids are written as .step, .stp, .iges, .igs, .brep, .xml and .off",
                            path.string()));
}

}  // namespace isopatch::geometry
