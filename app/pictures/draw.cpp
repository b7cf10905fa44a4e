#include "app/pictures/draw.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "app/pictures/module.hpp"
#include "app/pictures/virtual_display.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

namespace fs = std::filesystem;

/// The drawing module's functions, loaded once and for good: the libraries behind it cannot be unloaded.
struct Module {
  decltype(&isopatch_display_problem) display_problem = nullptr;
  decltype(&isopatch_draw) draw = nullptr;
};

constexpr const char* file_name = "isopatch_drawing.so";

/// Beside the program, as it is built, or in the library folder beside the program's, as it is installed.
fs::path find_module() {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  const std::array<fs::path, 2> places = {here / file_name,
                                          here / ".." / ISOPATCH_LIBRARY_FOLDER / "isopatch" / file_name};
  for (const fs::path& place : places)
    if (fs::exists(place, none)) return place;
  throw Error(ErrorCode::unsupported,
              fmt::format("the part of isopatch that draws is missing: {}; build or install "
                          "all of isopatch, for example with scripts/setup",
                          places[0].string()));
}

Module load_module() {
  const fs::path file = find_module();
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw Error(ErrorCode::unsupported,
                fmt::format("the part of isopatch that draws cannot be loaded: {}", ::dlerror()));
  Module module;
  module.display_problem =
      reinterpret_cast<decltype(module.display_problem)>(::dlsym(library, "isopatch_display_problem"));
  module.draw = reinterpret_cast<decltype(module.draw)>(::dlsym(library, "isopatch_draw"));
  if (module.display_problem == nullptr || module.draw == nullptr)
    throw Error(ErrorCode::unsupported,
                fmt::format("{} belongs to another version of isopatch", file.string()));
  return module;
}

std::string problem_of(const Module& module, const std::string& display) {
  std::string problem;
  module.display_problem(display, problem);
  return problem;
}

std::string drawn(const Module& module, const Picture& picture, const std::string& display) {
  std::string png;
  module.draw(picture, display, png);
  return png;
}

}  // namespace

std::string draw(const Picture& picture) {
  static const Module module = load_module();
  const char* named = std::getenv("DISPLAY");
  if (named != nullptr && *named != '\0' && problem_of(module, named).empty())
    return drawn(module, picture, named);
  const VirtualDisplay display;
  const std::string problem = problem_of(module, display.name());
  if (!problem.empty()) throw Error(ErrorCode::unsupported, fmt::format("Xvfb was started, but {}", problem));
  return drawn(module, picture, display.name());
}

}  // namespace isopatch::app
