#include "app/study/parse_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <variant>

#include "app/study/accuracy_keys.hpp"
#include "app/study/case_keys.hpp"
#include "app/study/config_section.hpp"
#include "app/study/load_keys.hpp"
#include "app/study/material_keys.hpp"
#include "app/study/model_keys.hpp"
#include "app/study/modes_keys.hpp"
#include "app/study/not_a_study.hpp"
#include "app/study/section_keys.hpp"
#include "app/study/study_documentation.hpp"
#include "app/study/study_keys.hpp"
#include "app/study/study_path.hpp"
#include "app/study/support_keys.hpp"
#include "geometry/base/atomic_file.hpp"

namespace isopatch::app {
namespace {

ProbeInput read_probe(const ConfigSection& input, std::size_t index) {
  const auto keys = read_table<ProbeKeys>(input.table, input.place, "[[probe]]", probe_keys());
  if (keys.point.has_value() == keys.patch.has_value() ||
      keys.patch.has_value() != keys.parameter.has_value())
    throw error_at(input.place, "[[probe]] needs either a point, or a patch with a parameter");
  const std::string name = keys.name.empty() ? fmt::format("probe {}", index + 1) : keys.name;
  if (keys.point) return {name, *keys.point, input.place};
  return {name, PatchParameter{*keys.patch, *keys.parameter}, input.place};
}

AccuracyInput read_accuracy(const ConfigSection& input) {
  auto accuracy = read_table<AccuracyInput>(input.table, input.place, "[accuracy]", accuracy_keys());
  accuracy.place = input.place;
  if (!input.table.entries.empty() && !accuracy.is_asked())
    throw error_at(input.place, "[accuracy] needs energy or stress, the largest error that is allowed");
  if (!accuracy.probe.empty() && !accuracy.stress)
    throw error_at(input.place, "accuracy.probe says whose stress is meant, but accuracy.stress is missing");
  return accuracy;
}

/// Along each direction of a patch that is fitted to a hexahedron, where the study does not say how fine:
/// what is straight is one element long otherwise, however long that is.
constexpr int least_of_fitted_patches = 2;

bool says_how_fine(const ConfigTable& discretization, const AccuracyInput& accuracy) {
  constexpr const char* keys[] = {"refine", "elements_per_direction", "max_size", "patch"};
  return accuracy.is_asked() || std::any_of(std::begin(keys), std::end(keys), [&](const char* key) {
           return discretization.find(key) != nullptr;
         });
}

void read_options(const StudyKeys& top, Study& study) {
  const ConfigSection discretization = section(top.discretization, "discretization", study.source);
  const auto space = read_table<DiscretizationKeys>(discretization.table, discretization.place,
                                                    "[discretization]", discretization_keys());
  study.discretization = space.options;
  for (const ConfigSection& input : sections(space.patch, "discretization.patch")) {
    auto own = read_table<PatchDiscretizationKeys>(input.table, input.place, "[[discretization.patch]]",
                                                   patch_discretization_keys());
    if (!own.patches && !own.reach.part)
      throw error_at(input.place,
                     "[[discretization.patch]] needs `patches`, or `part` for all that reach into a place");
    own.reach.place = input.place;
    study.patch_discretizations.push_back({own.patches.value_or(PatchSelection{.place = input.place}),
                                           std::move(own.reach), own.refinement, input.place});
  }
  const ConfigSection coupling = section(top.coupling, "coupling", study.source);
  const auto coupled =
      read_table<CouplingKeys>(coupling.table, coupling.place, "[coupling]", coupling_keys());
  study.options.coupling = coupled.method;
  study.options.non_matching = coupled.non_matching.value_or(iga::NonMatchingCoupling::nitsche);
  study.options.mortar_side = coupled.mortar_side;
  if (const ConfigEntry* side = coupling.table.find("mortar_side");
      side && coupled.non_matching != iga::NonMatchingCoupling::mortar)
    throw error_at(side->value.place,
                   "mortar_side says which side has the mortar multipliers, which are there with "
                   "coupling.non_matching = \"mortar\" alone: set that, or leave mortar_side away");
  study.discretization.spread = !coupled.non_matching;
  study.model.tolerance.keep_non_matching = coupled.non_matching.has_value();
  if (auto* blocks = std::get_if<BlocksInput>(&study.model.source))
    blocks->options.keep_t_joints = coupled.non_matching.has_value();
  study.options.quadrature_points = space.points;
  const ConfigSection solver = section(top.solver, "solver", study.source);
  study.options.solver =
      read_table<solvers::SolverOptions>(solver.table, solver.place, "[solver]", solver_keys());
  const ConfigSection modes = section(top.modes, "modes", study.source);
  study.modes = read_table<ModesInput>(modes.table, modes.place, "[modes]", modes_keys());
  const ConfigSection accuracy = section(top.accuracy, "accuracy", study.source);
  study.accuracy = read_accuracy(accuracy);
  const bool is_fitted = std::holds_alternative<BlocksInput>(study.model.source);
  if (is_fitted && !says_how_fine(discretization.table, study.accuracy))
    study.discretization.elements_per_direction.fill(least_of_fitted_patches);
  const ConfigSection output = section(top.output, "output", study.source);
  study.output = read_table<OutputInput>(output.table, output.place, "[output]", output_keys());
  const ConfigEntry* directory = output.table.find("directory");
  if (study.accuracy.is_asked() && !study.output.error_estimate)
    throw error_at(
        study.accuracy.place,
        "[accuracy] refines by the error estimate, which output.error_estimate = false leaves out: "
        "leave one away");
  study.output.directory = study_path(study.output.directory.string(),
                                      directory ? directory->value.place : output.place, study.source);
}

Study parsed(const std::string& text, const std::filesystem::path& source_name,
             const std::vector<std::string>& overrides) {
  Study study;
  study.source = source_name.string();
  study.text = text;
  ConfigTable table = parse_toml(text, study.source);
  for (const std::string& assignment : overrides) table = with_override(std::move(table), assignment);
  const auto top = read_table<StudyKeys>(table, {study.source, 0, 0}, "the study", study_keys());
  study.title = top.title;
  study.model = read_model(section(top.model, "model", study.source),
                           {section(top.parameterization, "parameterization", study.source),
                            section(top.segmentation, "segmentation", study.source),
                            section(top.reconstruction, "reconstruction", study.source)},
                           study.source);
  for (const ConfigSection& input : sections(top.material, "material"))
    study.materials.push_back(read_material(input));
  for (const ConfigSection& input : sections(top.support, "support"))
    study.supports.push_back(read_support(input, study.supports.size()));
  for (const ConfigSection& input : sections(top.load, "load"))
    study.loads.push_back(read_load(input, study.loads.size()));
  for (const ConfigSection& input : sections(top.combination, "combination"))
    study.combinations.push_back(read_combination(input, study.combinations.size()));
  for (const ConfigSection& input : sections(top.probe, "probe"))
    study.probes.push_back(read_probe(input, study.probes.size()));
  for (const ConfigSection& input : sections(top.section, "section"))
    study.sections.push_back(read_cut(input, study.sections.size()));
  read_options(top, study);
  return study;
}

// Where a key belongs that was written elsewhere: under another heading of the file, say, which ended too
// late.
std::vector<std::string> sections_with(const std::string& key) {
  std::vector<std::string> result;
  for (const SectionText& section : study_sections())
    for (const KeyText& text : section.keys)
      if (text.name == key) result.push_back(section.heading);
  return result;
}

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& source_name,
                  const std::vector<std::string>& overrides) {
  try {
    return parsed(text, source_name, overrides);
  } catch (const UnknownKey& error) {
    const std::vector<std::string> homes = sections_with(error.key());
    if (homes.empty() || homes.size() > 2) throw;
    throw Error(error.code(),
                fmt::format("{}. '{}' is a key of {}", error.what(), error.key(), fmt::join(homes, " and ")));
  }
}

Study read_study(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    const auto inside = path / "study.toml";
    throw Error(ErrorCode::io,
                fmt::format("{} is a directory; {}", path.string(),
                            std::filesystem::exists(inside) ? fmt::format("did you mean {}?", inside.string())
                                                            : "give a study's file"));
  }
  const std::string text = read_file(path);
  refuse_what_is_no_study(path, text);
  return parse_study(text, path, overrides);
}

}  // namespace isopatch::app
