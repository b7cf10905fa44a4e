#include "app/study/not_a_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/base/error.hpp"
#include "geometry/brep/read_brep.hpp"

namespace isopatch::app {
namespace {

/// Endings of models whose content does not tell them from a study at once.
bool is_model_name(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 4> endings = {".g2", ".mesh", ".xml", ".off"};
  return std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end() ||
         geometry::is_brep_file(path);
}

}  // namespace

void refuse_what_is_no_study(const std::filesystem::path& path, std::string_view text) {
  const std::string name = path.string();
  if (text.starts_with("\x89HDF"))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} holds results, not a study; `isopatch info {}` tells about them, and report, "
                            "probe, fields and render take them. A study is a .toml file",
                            name, name));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_markup = first != text.npos && text[first] == '<';
  if (is_markup || is_model_name(path))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format(
            "{} is a model, not a study; `isopatch info {}` describes it. A study is a .toml file that "
            "names it: file = \"{}\" under [model]; `isopatch keys` lists the rest",
            name, name, path.filename().string()));
}

}  // namespace isopatch::app
