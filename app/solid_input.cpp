#include "app/solid_input.hpp"

#include "geometry/base/atomic_file.hpp"
#include "geometry/io/read_gismo_solid.hpp"

namespace isopatch::app {

bool is_solid_file(const std::filesystem::path& path) {
  if (geometry::is_brep_file(path)) return true;
  return path.extension() == ".xml" && geometry::is_gismo_solid(read_file(path));
}

std::vector<SolidReport> load_solids(const InputFile& input) {
  geometry::ReadBrepOptions options;
  if (!input.length_unit.empty()) options.length_unit = length_unit(input);
  options.sew.accept_open = true;
  std::vector<SolidReport> result;
  for (geometry::BrepFile& file : geometry::read_breps(input.path, options)) {
    geometry::BrepReport report = geometry::check(file.brep);
    result.push_back({std::move(file), std::move(report)});
  }
  return result;
}

}  // namespace isopatch::app
