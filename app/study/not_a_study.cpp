#include "app/study/not_a_study.hpp"

#include <fmt/format.h>

#include "app/study/file_kind.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

/// Files that hold a model whatever their content is.
bool is_model_name(const std::filesystem::path& path) {
  const FileKind kind = kind_of(path);
  return kind == FileKind::patches || kind == FileKind::blocks || kind == FileKind::triangles ||
         holds_solids(kind);
}

}  // namespace

void refuse_what_is_no_study(const std::filesystem::path& path, std::string_view text) {
  const std::string name = path.string();
  if (text.starts_with("\x89HDF") && !is_model_name(path))
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
