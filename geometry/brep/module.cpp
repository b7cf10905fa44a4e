#include "geometry/brep/module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/internal/installed_part.hpp"

namespace isopatch::geometry {
namespace {

const BrepModule& load() {
  const std::filesystem::path file = brep_module_file();
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

std::filesystem::path brep_module_file() {
  return installed_part("isopatch_brep.so");
}

const BrepModule& brep_module() {
  static const BrepModule& module = load();
  return module;
}

}  // namespace isopatch::geometry
