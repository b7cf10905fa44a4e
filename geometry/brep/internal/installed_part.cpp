#include "geometry/brep/internal/installed_part.hpp"

#include <fmt/format.h>

#include <array>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

namespace fs = std::filesystem;

fs::path installed_part(const std::string& name) {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  const std::array<fs::path, 4> places = {
      here / name, here / ".." / ISOPATCH_LIBRARY_FOLDER / "isopatch" / name,
      fs::path(ISOPATCH_INSTALLED_LIBRARIES) / "isopatch" / name, fs::path(ISOPATCH_BUILT_MODULES) / name};
  for (const fs::path& place : places)
    if (fs::exists(place, none)) return place;
  throw Error(
      ErrorCode::unsupported,
      fmt::format(
          "the part of isopatch that reads CAD solids is missing: {}; build or install all of isopatch, "
          "for example with scripts/setup",
          places[0].string()));
}

}  // namespace isopatch::geometry
