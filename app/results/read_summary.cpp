#include "app/results/read_summary.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "app/base/internal/json_values.hpp"

namespace isopatch::app {
namespace {

const Json& at(const Json& json, const char* path) {
  static const Json nothing;
  const Json::json_pointer pointer(path);
  return json.is_structured() && json.contains(pointer) ? json[pointer] : nothing;
}

std::string text_at(const Json& json, const char* path) {
  const Json& found = at(json, path);
  return found.is_string() ? found.get<std::string>() : "";
}

std::optional<double> number_at(const Json& json, const char* path) {
  const Json& found = at(json, path);
  return found.is_number() ? std::optional(found.get<double>()) : std::nullopt;
}

Eigen::Vector3d vector_of(const Json& json) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  if (json.is_array() && json.size() == 3)
    for (std::size_t i = 0; i < 3; ++i)
      if (json[i].is_number()) result[static_cast<Eigen::Index>(i)] = json[i].get<double>();
  return result;
}

std::vector<std::string> texts_of(const Json& json) {
  std::vector<std::string> result;
  if (!json.is_array()) return result;
  for (const Json& text : json)
    if (text.is_string()) result.push_back(text.get<std::string>());
  return result;
}

std::vector<SummarizedRegion> stored_regions(const Json& regions) {
  std::vector<SummarizedRegion> result;
  if (!regions.is_array()) return result;
  for (const Json& region : regions)
    result.push_back({text_at(region, "/name"), text_at(region, "/kind"), texts_of(at(region, "/given")),
                      texts_of(at(region, "/faces")), vector_of(at(region, "/total"))});
  return result;
}

// Reactions come in the order of the supports.
void add_stored_reactions(std::vector<SummarizedRegion>& supports, const Json& reactions) {
  if (!reactions.is_array()) return;
  for (std::size_t i = 0; i < supports.size() && i < reactions.size(); ++i)
    supports[i].force = vector_of(at(reactions[i], "/force"));
}

std::optional<SummarizedPlace> stored_place(const Json& json) {
  const Json& patch = at(json, "/patch");
  if (!patch.is_number_integer()) return std::nullopt;
  return SummarizedPlace{text_at(json, "/name"), patch.get<int>(), vector_of(at(json, "/parameter"))};
}

std::vector<SummarizedPlace> stored_probes(const Json& probes) {
  std::vector<SummarizedPlace> result;
  if (!probes.is_array()) return result;
  for (const Json& probe : probes)
    if (const auto place = stored_place(probe)) result.push_back(*place);
  return result;
}

std::vector<Warning> stored_warnings(const Json& texts, const Json& places) {
  std::vector<Warning> result;
  if (!texts.is_array()) return result;
  for (const Json& text : texts) {
    Warning warning{text.is_string() ? text.get<std::string>() : "", {}, {}};
    if (places.is_array() && result.size() < places.size()) {
      const Json& place = places[result.size()];
      if (at(place, "/patch").is_number_integer()) warning.patch = at(place, "/patch").get<int>();
      if (at(place, "/point").is_array()) warning.place = vector_of(at(place, "/point"));
    }
    result.push_back(std::move(warning));
  }
  return result;
}

std::vector<RunLevel> stored_levels(const Json& levels) {
  std::vector<RunLevel> result;
  if (!levels.is_array()) return result;
  for (const Json& level : levels)
    result.push_back({.refine = static_cast<int>(number_at(level, "/refine").value_or(0)),
                      .unknowns = static_cast<std::int64_t>(number_at(level, "/dofs").value_or(0)),
                      .internal_energy = number_at(level, "/internal_energy").value_or(0),
                      .max_displacement = number_at(level, "/max_displacement").value_or(0),
                      .max_von_mises = number_at(level, "/max_von_mises").value_or(0),
                      .error = number_at(level, "/energy_norm_error"),
                      .seconds = number_at(level, "/seconds").value_or(0)});
  return result;
}

SummarizedSolver stored_solver(const Json& solver) {
  SummarizedSolver result{text_at(solver, "/method"), number_at(solver, "/tolerance").value_or(0),
                          static_cast<int>(number_at(solver, "/levels").value_or(0))};
  const Json& history = at(solver, "/residual_history");
  if (!history.is_array()) return result;
  for (const Json& residual : history)
    if (residual.is_number()) result.residual_history.push_back(residual.get<double>());
  return result;
}

// Puts what belongs to one case in the place of the first's.
void show_case(Json& json, const std::string& name) {
  const Json cases = at(json, "/cases");
  if (!cases.is_array()) return;
  for (const Json& one : cases) {
    if (text_at(one, "/name") != name && !(name.empty() && &one == &cases.front())) continue;
    for (const char* key : {"results", "probes", "sections", "solver", "levels", "convergence"})
      if (one.contains(key)) json[key] = one[key];
    const std::vector<std::string> own = texts_of(at(one, "/loads"));
    if (own.empty() || !at(json, "/loads").is_array()) continue;
    Json loads = Json::array();
    for (const Json& load : json["loads"])
      if (std::find(own.begin(), own.end(), text_at(load, "/name")) != own.end()) loads.push_back(load);
    json["loads"] = loads;
  }
}

}  // namespace

std::optional<RunSummary> read_summary(const std::string& text, const std::string& case_name) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  show_case(json, case_name);
  RunSummary summary;
  summary.title = text_at(json, "/title");
  summary.study = text_at(json, "/study");
  summary.max_displacement = number_at(json, "/results/max_displacement");
  summary.max_von_mises = number_at(json, "/results/max_von_mises");
  // It came with the search on faces.
  summary.faces_searched = !at(json, "/results/points_left_out").is_null();
  summary.internal_energy = number_at(json, "/results/internal_energy");
  summary.unknowns = static_cast<std::int64_t>(number_at(json, "/discretization/dofs").value_or(0));
  summary.supports = stored_regions(at(json, "/supports"));
  add_stored_reactions(summary.supports, at(json, "/results/reactions"));
  summary.loads = stored_regions(at(json, "/loads"));
  summary.max_displacement_at = stored_place(at(json, "/results/max_displacement_at"));
  summary.max_von_mises_at = stored_place(at(json, "/results/max_von_mises_at"));
  summary.probes = stored_probes(at(json, "/probes"));
  summary.warnings = stored_warnings(at(json, "/warnings"), at(json, "/warning_places"));
  summary.solver = stored_solver(at(json, "/solver"));
  summary.levels = stored_levels(at(json, "/levels"));
  for (RunLevel& level : summary.levels) level.is_adaptive = !at(json, "/accuracy").is_null();
  summary.asked_error = number_at(json, "/accuracy/energy");
  return summary;
}

std::vector<StageReport> read_stages(const std::string& text, const std::filesystem::path& folder) {
  const Json json = Json::parse(text, nullptr, false);
  std::vector<StageReport> result;
  const Json& stages = at(json, "/stages");
  if (!stages.is_array()) return result;
  for (const Json& stage : stages) {
    const Stage* which = find_choice(stage_choices(), text_at(stage, "/name"));
    const std::string file = text_at(stage, "/file"), content = text_at(stage, "/content");
    if (!which || file.empty()) continue;
    result.push_back({.stage = *which,
                      .kept = true,
                      .file = folder / file,
                      .made = text_at(stage, "/made"),
                      .seconds = number_at(stage, "/seconds").value_or(0)});
    std::from_chars(content.data(), content.data() + content.size(), result.back().content, 16);
  }
  return result;
}

std::string summary_of_case(const std::string& text, const std::string& case_name) {
  Json json = Json::parse(text, nullptr, false);
  if (case_name.empty() || !json.is_object()) return text;
  show_case(json, case_name);
  json["case"] = case_name;
  return file_text(json);
}

}  // namespace isopatch::app
