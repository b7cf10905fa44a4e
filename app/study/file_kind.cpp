#include "app/study/solid_file.hpp"

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/io/read_gismo_solid.hpp"

namespace isopatch::app {

bool is_solid_file(const std::filesystem::path& path) {
  if (geometry::is_brep_file(path)) return true;
  return path.extension() == ".xml" && geometry::is_gismo_solid(read_file(path));
}

}  // namespace isopatch::app
