#include "geometry/brep/module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "isopatch_brep.so";

/// Beside the program, in the library folder beside the program's, where isopatch was installed, where it was
/// built.
fs::path find_module() {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  const std::array<fs::path, 4> places = {here / file_name,
                                          here / ".." / ISOPATCH_LIBRARY_FOLDER / "isopatch" / file_name,
                                          fs::path(ISOPATCH_INSTALLED_LIBRARIES) / "isopatch" / file_name,
                                          fs::path(ISOPATCH_BUILT_MODULES) / file_name};
  for (const fs::path& place : places)
    if (fs::exists(place, none)) return place;
  throw Error(
      ErrorCode::unsupported,
      fmt::format("the part of isopatch that reads CAD solids is missing: {}; build or install all of "
                  "isopatch, for example with scripts/setup",
                  places[0].string()));
}

const BrepModule& load() {
  const fs::path file = find_module();
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw Error(ErrorCode::unsupported,
                fmt::format("the part of isopatch that reads CAD solids cannot be loaded: {}", ::dlerror()));
  const auto entry =
      reinterpret_cast<decltype(&isopatch_brep_module)>(::dlsym(library, "isopatch_brep_module"));
  if (entry == nullptr)
    throw Error(ErrorCode::unsupported,
                fmt::format("{} belongs to another version of isopatch", file.string()));
  return *entry();
}

}  // namespace

const BrepModule& brep_module() {
  static const BrepModule& module = load();
  return module;
}

}  // namespace isopatch::geometry
