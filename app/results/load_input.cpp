#include "app/results/load_input.hpp"

#include <fmt/format.h>

#include "app/base/internal/json_values.hpp"
#include "app/base/units.hpp"
#include "app/problem/build_problem.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

std::string title_of(const Study& study, const std::filesystem::path& path) {
  return study.title.empty() ? path.filename().string() : study.title;
}

LoadedInput load_result(const std::filesystem::path& path) {
  iga::StoredResult result = iga::read_result(path);
  geometry::MultiPatch model = iga::model_of(result);
  const Json summary = Json::parse(result.summary, nullptr, false);
  const bool titled = summary.is_object() && summary.contains("title") && summary["title"].is_string();
  const std::string title = titled ? summary["title"].get<std::string>() : "";
  return {std::move(model), std::move(result), title.empty() ? path.filename().string() : title};
}

}  // namespace

double length_unit(const InputFile& input) {
  const std::string& text = input.length_unit;
  if (text.empty()) return 1;
  const Quantity unit = parse_scale(text);
  const bool plain = unit.dimension == dimensions::none;
  if ((unit.dimension != dimensions::length && !plain) || !(unit.value > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--length-unit: expected a length such as mm or '225 mm', got '{}'", text));
  return unit.value;
}

LoadedInput load_input(const InputFile& input) {
  const auto extension = input.path.extension();
  if (extension == ".h5") return load_result(input.path);
  if (extension == ".toml") {
    const Study study = read_study(input.path, input.overrides);
    LoadedInput result{load_model(study.model).model, std::nullopt, title_of(study, input.path)};
    for (const SupportInput& support : study.supports)
      if (!support.edges) result.held.push_back(support.selection);
    for (const LoadInput& load : study.loads)
      if (load.kind != LoadKind::body_force && load.kind != LoadKind::gravity)
        result.loaded.push_back(load.selection);
    return result;
  }
  ModelInput model;
  model.file = input.path;
  model.length_unit = length_unit(input);
  return {load_model(model).model, std::nullopt, input.path.filename().string()};
}

}  // namespace isopatch::app
