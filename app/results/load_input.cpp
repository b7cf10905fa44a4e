#include "app/results/load_input.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "app/base/units.hpp"
#include "app/problem/build_problem.hpp"
#include "app/results/read_summary.hpp"
#include "app/study/file_kind.hpp"
#include "app/study/parse_study.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

std::string title_of(const Study& study, const std::filesystem::path& path) {
  return study.title.empty() ? path.filename().string() : study.title;
}

LoadedInput load_result(const std::filesystem::path& path, const std::string& case_name) {
  iga::StoredResult result = iga::read_result(path, case_name);
  geometry::MultiPatch model = iga::model_of(result);
  std::optional<RunSummary> summary = read_summary(result.summary, result.case_name);
  const std::string title = summary ? summary->title : "";
  return {std::move(model), std::move(result), title.empty() ? path.filename().string() : title,
          std::move(summary)};
}

LoadedInput load_study(const InputFile& input) {
  const Study study = read_study(input.path, input.overrides);
  LoadedInput result{load_model(study.model).model, std::nullopt, title_of(study, input.path)};
  for (const SupportInput& support : study.supports) {
    const auto* held = std::get_if<HeldDisplacement>(&support.condition);
    const FaceSelection& selection = support.selection;
    const bool has_faces = !selection.faces.empty() || selection.where;
    if (has_faces && (!held || !held->edges)) result.held.push_back(selection);
  }
  for (const AppliedLoad& load : study.loads)
    if (const FaceSelection* selection = faces_of(load)) result.loaded.push_back(*selection);
  return result;
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
  const FileKind kind = kind_of(input.path);
  if (kind == FileKind::results) return load_result(input.path, input.case_name);
  if (kind == FileKind::study) return load_study(input);
  if (kind == FileKind::blocks)
    throw Error(ErrorCode::unsupported,
                fmt::format("{} holds blocks, which are no patches yet; give it to a study: [model] file, or "
                            "make patches of it with `isopatch parameterize`",
                            input.path.string()));
  const ModelInput model{PatchFile{input.path, length_unit(input)}};
  return {load_model(model).model, std::nullopt, input.path.filename().string()};
}

}  // namespace isopatch::app
