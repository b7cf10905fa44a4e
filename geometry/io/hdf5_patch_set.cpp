#include "geometry/io/hdf5_patch_set.hpp"

#include <fmt/format.h>

#include "geometry/io/hdf5_nurbs.hpp"
#include "geometry/io/internal/hdf5_faces.hpp"

namespace isopatch::geometry {
namespace {

std::string name_path(const std::string& group, std::size_t patch) {
  return fmt::format("{}/names/{:05}", group, patch);
}

}  // namespace

void write_patch_set(Hdf5Writer& file, const std::string& group, const PatchSet& set) {
  write_volumes(file, group + "/patches", set.patches);
  write_interfaces(file, group + "/interfaces", set.interfaces);
  write_boundaries(file, group, set.boundaries);
  file.write(group + "/name_count", static_cast<std::int64_t>(set.names.size()));
  for (std::size_t p = 0; p < set.names.size(); ++p) file.write(name_path(group, p), set.names[p]);
}

PatchSet read_patch_set(const Hdf5Reader& file, const std::string& group) {
  PatchSet set;
  set.patches = read_volumes(file, group + "/patches");
  set.interfaces = read_interfaces(file, group + "/interfaces");
  set.boundaries = read_boundaries(file, group);
  const std::int64_t names = file.integer(group + "/name_count");
  for (std::int64_t p = 0; p < names; ++p)
    set.names.push_back(file.text(name_path(group, static_cast<std::size_t>(p))));
  return set;
}

}  // namespace isopatch::geometry
