#include <fmt/format.h>

#include <algorithm>

#include "app/study/attachment_keys.hpp"
#include "app/study/not_a_study.hpp"
#include "app/study/solid_file.hpp"
#include "app/study/standard_materials.hpp"
#include "app/study/study_keys.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

std::filesystem::path resolved(const std::string& path, const Place& place, const std::string& source) {
  try {
    const std::filesystem::path expanded = expand_variables(path);
    if (expanded.empty()) throw Error(ErrorCode::invalid_argument, "the path is empty");
    return expanded.is_absolute() ? expanded : std::filesystem::path(source).parent_path() / expanded;
  } catch (const Error& error) {
    throw error_at(place, error.what());
  }
}

/// A section's table, or an empty one.
struct Section {
  ConfigTable table;
  Place place;
};

Section section(const std::optional<ConfigValue>& value, const std::string& name, const std::string& source) {
  if (!value) return {{}, {source, 0, 0}};
  return {read_subtable(*value, name), value->place};
}

/// The tables of [[name]].
std::vector<Section> sections(const std::optional<ConfigValue>& value, const std::string& name) {
  if (!value) return {};
  const auto* items = std::get_if<std::vector<ConfigValue>>(&value->value);
  if (!items)
    throw error_at(value->place,
                   fmt::format("{}: write [[{}]] with two brackets, as there may be several", name, name));
  std::vector<Section> result;
  for (const ConfigValue& item : *items) result.push_back({read_subtable(item, name), item.place});
  return result;
}

const GeneratedModel& find_generator(const ConfigValue& value) {
  std::vector<std::string> names;
  for (const GeneratedModel& model : generated_models()) names.push_back(model.name);
  return generated_models()[read_choice(value, "generate", names)];
}

AttachmentInput read_attachment(const Section& input, double length_unit) {
  const auto keys = read_table<AttachmentKeys>(input.table, input.place, "[[model.attach]]",
                                               attachment_keys({length_unit}));
  if (keys.move.isZero(0) && (keys.scale.array() == 1).all())
    throw error_at(input.place, "[[model.attach]] needs move or scale: where does the new patch end?");
  AttachmentInput result{keys.name, keys.faces, Eigen::Affine3d::Identity(), input.place};
  result.map.translate(keys.about + keys.move).scale(keys.scale).translate(-keys.about);
  return result;
}

/// The solids that a model is made of, if it is made of any.
std::optional<BlocksInput> read_blocks(const ModelKeys& keys, const Section& input, const Section& how,
                                       const std::string& source) {
  BlocksInput blocks;
  const auto path = [&](const std::string& text, const char* key) {
    return resolved(text, input.table.find(key)->value.place, source);
  };
  for (const std::string& file : keys.blocks) blocks.files.files.push_back(path(file, "blocks"));
  if (keys.file) {
    const std::filesystem::path file = path(*keys.file, "file");
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && is_solid_file(file)) blocks.files.files.push_back(file);
  }
  if (blocks.files.files.empty()) {
    if (keys.pairs) throw error_at(input.place, "pairs says how blocks meet, but [model] has no blocks");
    return std::nullopt;
  }
  const auto options =
      read_table<ParameterizationKeys>(how.table, how.place, "[parameterization]", parameterization_keys());
  blocks.options = options.options;
  blocks.options.names = {"parameterization.max_spans", "parameterization.tolerance"};
  blocks.files.assembly.same_point = options.same_point;
  if (keys.gives_length_unit) blocks.files.length_unit = keys.length_unit;
  blocks.files.allow_partial = keys.allow_partial;
  blocks.files.limits = {keys.cad_time_limit, static_cast<std::uint64_t>(keys.cad_memory_limit)};
  if (keys.pairs) blocks.files.pairs = path(*keys.pairs, "pairs");
  try {
    segmentation::validate(blocks.options);
  } catch (const Error& error) {
    throw error_at(how.place, error.what());
  }
  return blocks;
}

ModelInput read_model(const Section& input, const Section& parameterization, const std::string& source) {
  const ConfigEntry* generate = input.table.find("generate");
  const GeneratedModel* generator = generate ? &find_generator(generate->value) : nullptr;
  std::vector<std::string> known = names(model_keys());
  ConfigTable common;
  ConfigTable dimensions;
  for (const ConfigEntry& entry : input.table.entries) {
    const bool is_common = std::find(known.begin(), known.end(), entry.name) != known.end();
    (is_common || !generator ? common : dimensions).entries.push_back(entry);
  }
  if (generator) {
    for (const KeyText& key : generator->keys) known.push_back(key.name);
    for (const ConfigEntry& entry : dimensions.entries)
      if (std::find(known.begin(), known.end(), entry.name) == known.end())
        throw unknown_key(entry, fmt::format("[model] with generate = \"{}\"", generator->name), known);
  }
  const auto keys = read_table<ModelKeys>(common, input.place, "[model]", model_keys());
  if (keys.file.has_value() + keys.generate.has_value() + !keys.blocks.empty() != 1)
    throw error_at(input.place,
                   "[model] needs either file = \"...\", blocks = [\"...\"] or generate = \"...\"");
  ModelInput model;
  model.place = input.place;
  model.length_unit = keys.length_unit;
  model.tolerance = {.same_point = keys.same_point, .near_miss = keys.near_miss, .same_knot = keys.same_knot};
  if (keys.near_miss <= keys.same_point) throw error_at(input.place, "near_miss must be above same_point");
  if (keys.file) model.file = resolved(*keys.file, input.table.find("file")->value.place, source);
  model.blocks = read_blocks(keys, input, parameterization, source);
  if (!model.blocks && !parameterization.table.entries.empty())
    throw error_at(parameterization.place,
                   "[parameterization] is for solids, but [model] has patches already; remove one");
  if (generator) {
    model.generate = generator->name;
    model.generator = generator->read(dimensions, input.place, keys.length_unit);
  }
  for (const Section& attachment : sections(keys.attach, "model.attach"))
    model.attachments.push_back(read_attachment(attachment, keys.length_unit));
  return model;
}

iga::Material read_standard_material(const MaterialKeys& keys, const Place& place) {
  if (!keys.name)
    throw error_at(
        place,
        "[[material]] needs elastic constants: lame, young and poisson, or the name of a known material");
  std::vector<std::string> known;
  for (const StandardMaterial& material : standard_materials()) {
    known.push_back(material.name);
    if (material.name == *keys.name)
      return iga::isotropic(material.young, material.poisson, keys.density.value_or(material.density),
                            material.name);
  }
  throw error_at(place,
                 fmt::format("no material named \"{}\"{}; known: {}. Others need lame, or young and poisson",
                             *keys.name, did_you_mean(*keys.name, known), fmt::join(known, ", ")));
}

iga::Material read_constants(const MaterialKeys& keys, const Place& place) {
  const bool engineering = keys.young || keys.poisson;
  if (keys.lame && engineering)
    throw error_at(place, "[[material]] has both lame and young or poisson; keep one");
  if (engineering && !(keys.young && keys.poisson))
    throw error_at(place, fmt::format("[[material]] has {} but lacks {}", keys.young ? "young" : "poisson",
                                      keys.young ? "poisson" : "young"));
  if (!keys.lame && !engineering) return read_standard_material(keys, place);
  const double density = keys.density.value_or(0);
  const std::string name = keys.name.value_or("");
  try {
    if (engineering) return iga::isotropic(*keys.young, *keys.poisson, density, name);
    const iga::Material material{keys.lame->lambda, keys.lame->mu, density, name};
    iga::validate(material);
    return material;
  } catch (const Error& error) {
    throw error_at(place, error.what());
  }
}

MaterialInput read_material(const Section& input) {
  const auto keys = read_table<MaterialKeys>(input.table, input.place, "[[material]]", material_keys());
  return {keys.patches.value_or(PatchSelection{{}, {}, input.place}), read_constants(keys, input.place),
          input.place};
}

SupportInput read_support(const Section& input, std::size_t index) {
  const auto keys = read_table<SupportKeys>(input.table, input.place, "[[support]]", support_keys());
  const bool displaced = keys.displacement || keys.displacement_gradient;
  const bool plane = keys.symmetry || keys.roller;
  if (displaced == plane)
    throw error_at(
        input.place,
        displaced
            ? "[[support]] has both a displacement and symmetry or roller; write two supports"
            : "[[support]] needs displacement, displacement_gradient, symmetry = true or roller = true");
  if (keys.faces.empty() && !keys.where)
    throw error_at(input.place, "[[support]] needs faces or where: which faces are held?");
  if (keys.normal_displacement && !keys.roller)
    throw error_at(input.place, "normal_displacement needs roller = true");
  if (keys.edges && plane)
    throw error_at(input.place,
                   "[[support]] has edges: symmetry and roller need whole faces, because an edge "
                   "has no normal; give displacement components");
  SupportInput result;
  result.name = fmt::format("support {}{}", index + 1, keys.name.empty() ? "" : " (" + keys.name + ")");
  result.key = keys.name.empty() ? result.name : keys.name;
  result.selection = {keys.faces, keys.where, input.place};
  result.edges = keys.edges;
  if (plane) {
    result.kind = keys.symmetry ? SupportKind::symmetry : SupportKind::roller;
    result.condition = iga::PlaneSupport{keys.normal_displacement.value_or(0)};
  } else {
    iga::PrescribedDisplacement condition;
    if (keys.displacement) condition.value = *keys.displacement;
    if (keys.displacement_gradient) condition.gradient = *keys.displacement_gradient;
    result.condition = condition;
  }
  return result;
}

LoadInput read_load(const Section& input, std::size_t index) {
  const auto keys = read_table<LoadKeys>(input.table, input.place, "[[load]]", load_keys());
  LoadInput result;
  result.name = fmt::format("load {}{}", index + 1, keys.name.empty() ? "" : " (" + keys.name + ")");
  result.key = keys.name.empty() ? result.name : keys.name;
  result.selection = {keys.faces, keys.where, input.place};
  result.patches = keys.patches.value_or(PatchSelection{{}, {}, input.place});
  int kinds = 0;
  const auto take = [&](const std::optional<Eigen::Vector3d>& vector, LoadKind kind) {
    if (!vector) return;
    ++kinds;
    result.kind = kind;
    result.vector = *vector;
  };
  take(keys.traction, LoadKind::traction);
  take(keys.force, LoadKind::force);
  take(keys.body_force, LoadKind::body_force);
  take(keys.gravity, LoadKind::gravity);
  if (keys.pressure) {
    ++kinds;
    result.kind = LoadKind::pressure;
    result.pressure = *keys.pressure;
  }
  if (kinds != 1)
    throw error_at(input.place,
                   "[[load]] needs exactly one of traction, pressure, force, body_force, gravity");
  const bool in_patches = result.kind == LoadKind::body_force || result.kind == LoadKind::gravity;
  const bool has_faces = !keys.faces.empty() || keys.where;
  if (!in_patches && !has_faces)
    throw error_at(input.place, "[[load]] needs faces or where: which faces are loaded?");
  if (in_patches && has_faces)
    throw error_at(input.place, "[[load]]: body_force and gravity act in patches, not on faces");
  if (!in_patches && keys.patches)
    throw error_at(input.place, "[[load]]: only body_force and gravity take patches; use faces");
  return result;
}

ProbeInput read_probe(const Section& input, std::size_t index) {
  const auto keys = read_table<ProbeKeys>(input.table, input.place, "[[probe]]", probe_keys());
  if (keys.point.has_value() == keys.patch.has_value() ||
      keys.patch.has_value() != keys.parameter.has_value())
    throw error_at(input.place, "[[probe]] needs either a point, or a patch with a parameter");
  return {keys.name.empty() ? fmt::format("probe {}", index + 1) : keys.name, keys.point, keys.patch,
          keys.parameter.value_or(Eigen::Vector3d::Zero()), input.place};
}

void read_options(const StudyKeys& top, Study& study) {
  const Section discretization = section(top.discretization, "discretization", study.source);
  const auto space = read_table<DiscretizationKeys>(discretization.table, discretization.place,
                                                    "[discretization]", discretization_keys());
  study.discretization = space.options;
  const Section coupling = section(top.coupling, "coupling", study.source);
  study.options =
      read_table<iga::ElasticityOptions>(coupling.table, coupling.place, "[coupling]", coupling_keys());
  study.options.quadrature_points = space.points;
  const Section solver = section(top.solver, "solver", study.source);
  study.options.solver =
      read_table<solvers::SolverOptions>(solver.table, solver.place, "[solver]", solver_keys());
  const Section output = section(top.output, "output", study.source);
  const auto files = read_table<OutputKeys>(output.table, output.place, "[output]", output_keys());
  study.output = {resolved(files.directory, output.place, study.source), files.fields, files.field_options,
                  files.hdf5, files.report};
}

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& source_name,
                  const std::vector<std::string>& overrides) {
  Study study;
  study.source = source_name.string();
  study.text = text;
  ConfigTable table = parse_toml(text, study.source);
  for (const std::string& assignment : overrides) table = with_override(std::move(table), assignment);
  const auto top = read_table<StudyKeys>(table, {study.source, 0, 0}, "the study", study_keys());
  study.title = top.title;
  study.model = read_model(section(top.model, "model", study.source),
                           section(top.parameterization, "parameterization", study.source), study.source);
  for (const Section& input : sections(top.material, "material"))
    study.materials.push_back(read_material(input));
  for (const Section& input : sections(top.support, "support"))
    study.supports.push_back(read_support(input, study.supports.size()));
  for (const Section& input : sections(top.load, "load"))
    study.loads.push_back(read_load(input, study.loads.size()));
  for (const Section& input : sections(top.probe, "probe"))
    study.probes.push_back(read_probe(input, study.probes.size()));
  read_options(top, study);
  return study;
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

std::string expand_variables(const std::string& text) {
  std::string result;
  std::size_t position = 0;
  for (;;) {
    const std::size_t begin = text.find("${", position);
    result += text.substr(position, begin - position);
    if (begin == std::string::npos) return result;
    const std::size_t end = text.find('}', begin);
    if (end == std::string::npos)
      throw Error(ErrorCode::invalid_argument, fmt::format("'${{' without '}}' in \"{}\"", text));
    const std::string inside = text.substr(begin + 2, end - begin - 2);
    const std::size_t fallback = inside.find(":-");
    const std::string name = inside.substr(0, fallback);
    const char* value = std::getenv(name.c_str());
    if (value && *value) {
      result += value;
    } else if (fallback != std::string::npos) {
      result += inside.substr(fallback + 2);
    } else {
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("the environment variable {} is not set; set it, or write ${{{}:-default}}",
                              name, name));
    }
    position = end + 1;
  }
}

}  // namespace isopatch::app
