#include "app/study/model_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "app/study/attachment_keys.hpp"
#include "app/study/config_text.hpp"
#include "app/study/file_kind.hpp"
#include "app/study/generated_models.hpp"
#include "app/study/parameterization_keys.hpp"
#include "app/study/reconstruction_keys.hpp"
#include "app/study/segmentation_keys.hpp"
#include "app/study/study_path.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

/// Reads the paths that [model] gives, with the places of their keys.
struct ModelPaths {
  const ConfigTable& table;
  const std::string& source;

  std::filesystem::path operator()(const std::string& text, const char* key) const {
    return study_path(text, table.find(key)->value.place, source);
  }
};

/// How solids become patches.
BlocksInput read_solids(std::vector<std::filesystem::path> files, const ModelKeys& keys,
                        const ModelPaths& path, const ConfigSection& how) {
  const auto options =
      read_table<ParameterizationKeys>(how.table, how.place, "[parameterization]", parameterization_keys());
  BlocksInput solids;
  solids.options = options.options;
  solids.gives_tolerance = options.gives_tolerance;
  solids.options.names = {"parameterization.max_spans", "parameterization.tolerance"};
  solids.files.files = std::move(files);
  solids.files.assembly.same_point = options.same_point;
  if (keys.gives_length_unit) solids.files.length_unit = keys.length_unit;
  solids.files.allow_partial = keys.allow_partial;
  solids.files.limits = {keys.cad_time_limit, static_cast<std::uint64_t>(keys.cad_memory_limit)};
  if (keys.pairs) solids.files.pairs = path(*keys.pairs, "pairs");
  try {
    segmentation::validate(solids.options);
  } catch (const Error& error) {
    throw error_at(how.place, error.what());
  }
  return solids;
}

/// Blocks that `isopatch segment` has written.
BlocksInput read_blocks(const ModelKeys& keys, const ConfigSection& input, const SolidSections& how,
                        const ModelPaths& path) {
  if (!how.segmentation.table.entries.empty())
    throw error_at(how.segmentation.place,
                   "[segmentation] cuts solids; those of `file` are blocks already; remove one");
  if (keys.gives_length_unit)
    throw error_at(input.place, "length_unit: the blocks of `file` are in metres already; remove it");
  return read_solids({path(*keys.file, "file")}, keys, path, how.parameterization);
}

/// [reconstruction], which is for triangles.
segmentation::ReconstructionOptions read_reconstruction(const ConfigSection& how) {
  const auto options =
      read_table<ReconstructionKeys>(how.table, how.place, "[reconstruction]", reconstruction_keys()).options;
  try {
    segmentation::validate(options);
  } catch (const Error& error) {
    throw error_at(how.place, error.what());
  }
  return options;
}

/// A file of patches or of solids, or several files of solids.
ModelSource read_files(const ModelKeys& keys, const ConfigSection& input, const SolidSections& how,
                       const std::string& source) {
  const ModelPaths path{input.table, source};
  std::vector<std::filesystem::path> solids;
  for (const std::string& file : keys.blocks) solids.push_back(path(file, "blocks"));
  if (!solids.empty()) {
    if (!how.segmentation.table.entries.empty())
      throw error_at(
          how.segmentation.place,
          "[segmentation] cuts the solids of `file`; those of `blocks` are hexahedra already; remove one");
    return read_solids(std::move(solids), keys, path, how.parameterization);
  }
  if (keys.file && kind_of(path(*keys.file, "file")) == FileKind::blocks)
    return read_blocks(keys, input, how, path);
  const FileKind kind = keys.file ? kind_of(path(*keys.file, "file")) : FileKind::unknown;
  if (holds_solids(kind) || kind == FileKind::triangles) {
    BlocksInput whole = read_solids({path(*keys.file, "file")}, keys, path, how.parameterization);
    whole.decomposition = read_table<SegmentationKeys>(how.segmentation.table, how.segmentation.place,
                                                       "[segmentation]", segmentation_keys())
                              .options;
    if (kind != FileKind::triangles && !how.reconstruction.table.entries.empty())
      throw error_at(how.reconstruction.place,
                     "[reconstruction] is for triangles, but `file` holds solids already; remove one");
    whole.reconstruction = read_reconstruction(how.reconstruction);
    return whole;
  }
  return PatchFile{path(*keys.file, "file"), keys.length_unit};
}

/// [model] in two: the keys that all models have, and the dimensions of a generated one.
struct ModelTables {
  ConfigTable common;
  ConfigTable dimensions;
  const GeneratedModel* generator = nullptr;
};

ModelTables divided(const ConfigTable& table) {
  ModelTables result;
  if (const ConfigEntry* generate = table.find("generate"))
    result.generator = &read_choice(generate->value, "generate", generated_model_choices()).get();
  std::vector<std::string> known = names(model_keys());
  for (const ConfigEntry& entry : table.entries) {
    const bool is_common = std::find(known.begin(), known.end(), entry.name) != known.end();
    (is_common || !result.generator ? result.common : result.dimensions).entries.push_back(entry);
  }
  if (!result.generator) return result;
  for (const KeyText& key : result.generator->keys) known.push_back(key.name);
  for (const ConfigEntry& entry : result.dimensions.entries)
    if (std::find(known.begin(), known.end(), entry.name) == known.end())
      throw unknown_key(entry, fmt::format("[model] with generate = \"{}\"", result.generator->name), known);
  return result;
}

ModelSource read_source(const ModelKeys& keys, const ModelTables& tables, const ConfigSection& input,
                        const SolidSections& how, const std::string& source) {
  if (!tables.generator) return read_files(keys, input, how, source);
  return GeneratedInput{tables.generator->read(tables.dimensions, input.place, keys.length_unit),
                        keys.length_unit};
}

void check(const ModelKeys& keys, const Place& place) {
  if (keys.file.has_value() + keys.generate.has_value() + !keys.blocks.empty() != 1)
    throw error_at(place, "[model] needs either file = \"...\", blocks = [\"...\"] or generate = \"...\"");
  if (keys.near_miss <= keys.same_point) throw error_at(place, "near_miss must be above same_point");
}

/// What the stages from solids to patches depend on besides the content of files.
StageTexts texts_of(const ConfigSection& input, const SolidSections& how) {
  return {.model = config_text(input.table, {"file", "blocks", "pairs", "attach", "same_point", "near_miss",
                                             "same_knot", "cad_time_limit", "cad_memory_limit"}),
          .reconstruction = config_text(how.reconstruction.table),
          .segmentation = config_text(how.segmentation.table),
          .parameterization = config_text(how.parameterization.table)};
}

}  // namespace

const Keys<ModelKeys>& model_keys() {
  static const Keys<ModelKeys> keys = {
      optional_text_key<ModelKeys>(
          "file", &ModelKeys::file,
          "A file of patches: G+Smo XML (.xml), GoTools (.g2) or MFEM NURBS mesh (.mesh). Relative "
          "paths count from the study's folder; ${NAME} and ${NAME:-default} are environment "
          "variables. Or a file of solids in any format of `blocks`: those that are no topological hexahedra "
          "are cut "
          "into such, as [segmentation] says; faces keep their names, \"face 3\" where they have none. Or "
          "triangles (.stl, .obj, .ply, .3mf), from which [reconstruction] makes a solid with faces called "
          "\"plane_1\", "
          "\"cylinder_1\", ..., each kind in the order of area. Or "
          "blocks.h5, as `isopatch segment` writes it, whose blocks are not cut again. "
          "Either this, "
          "`blocks` or `generate`."),
      custom_key<ModelKeys>(
          "blocks", "array of strings",
          "Files of solids that are topological hexahedra: STEP (.step, .stp, .p21), IGES "
          "(.iges, .igs), OpenCASCADE "
          "(.brep, .brp), G+Smo solids (.xml), polyhedra (.off). [parameterization] says how "
          "each becomes a patch; their "
          "outer faces are boundaries called \"block:face\"; all of one colour in STEP files are "
          "the boundary \"#rrggbb\".",
          [](ModelKeys& target, const ConfigValue& value) {
            for (const ConfigValue& item : read_array(value, "blocks"))
              target.blocks.push_back(read_text(item, "blocks"));
          }),
      optional_text_key<ModelKeys>("pairs", &ModelKeys::pairs,
                                   "With blocks, a file that says how they meet, a line each: block, number "
                                   "of its face, block, number of its "
                                   "face. Without it the pairs are found from the geometry."),
      optional_text_key<ModelKeys>(
          "generate", &ModelKeys::generate,
          "Name of a generated model, whose dimensions are further keys of [model]; see below."),
      value_key<ModelKeys>("attach", "array of tables", &ModelKeys::attach,
                           "Patches to be added to faces of the model."),
      custom_key<ModelKeys>(
          "length_unit", "length (m), with or without a number",
          "What one unit of the file's (or the generated model's) coordinates measures: \"mm\", "
          "\"225 mm\", 0.0254. All other lengths of the study are in m or have a unit.",
          [](ModelKeys& target, const ConfigValue& value) {
            target.length_unit = read_length_unit(value);
            target.gives_length_unit = true;
          })
          .with_default("\"m\"; STEP, IGES and 3MF files say it themselves"),
      custom_key<ModelKeys>("allow_partial", "true or false",
                            "Whether bodies and faces of CAD files that cannot be read, and bodies that are "
                            "not closed, are left out with "
                            "a warning. Otherwise they are an error.",
                            [](ModelKeys& target, const ConfigValue& value) {
                              target.allow_partial = read_flag(value, "allow_partial");
                            })
          .with_default("false"),
      quantity_key<ModelKeys>(
          "cad_time_limit", &ModelKeys::cad_time_limit, dim::none, {0, 1e7},
          "Seconds of computing that a STEP, IGES or .brep file may take to be read; 0 means 60 "
          "seconds and 10 for each megabyte."),
      quantity_key<ModelKeys>(
          "cad_memory_limit", &ModelKeys::cad_memory_limit, dim::none, {0, 1e15},
          "Bytes of memory that a STEP, IGES or .brep file may take to be read; 0 means three "
          "quarters of the machine's, any other value is 5e7 at least."),
      quantity_key<ModelKeys>(
          "same_point", &ModelKeys::same_point, dim::none, {0, 1e-2, false, false},
          "Points closer than this share of the model's size are one point: faces that agree so well "
          "are interfaces."),
      quantity_key<ModelKeys>(
          "near_miss", &ModelKeys::near_miss, dim::none, {0, 0.1, false, false},
          "Faces that agree only to this share of the model's size are refused as a gap."),
      quantity_key<ModelKeys>(
          "same_knot", &ModelKeys::same_knot, dim::none, {0, 1e-3, false, false},
          "Knots of two neighbours closer than this share of the knot range are one knot."),
  };
  return keys;
}

ModelInput read_model(const ConfigSection& input, const SolidSections& how, const std::string& source) {
  const ModelTables tables = divided(input.table);
  const auto keys = read_table<ModelKeys>(tables.common, input.place, "[model]", model_keys());
  check(keys, input.place);
  ModelInput model{read_source(keys, tables, input, how, source)};
  model.place = input.place;
  model.tolerance = {.same_point = keys.same_point, .near_miss = keys.near_miss, .same_knot = keys.same_knot};
  if (auto* solids = std::get_if<BlocksInput>(&model.source)) {
    solids->texts = texts_of(input, how);
  } else {
    if (keys.pairs) throw error_at(input.place, "pairs says how blocks meet, but [model] has no blocks");
    for (const auto& [section, name] :
         {std::pair(&how.parameterization, "[parameterization]"),
          std::pair(&how.segmentation, "[segmentation]"), std::pair(&how.reconstruction, "[reconstruction]")})
      if (!section->table.entries.empty())
        throw error_at(section->place,
                       fmt::format("{} is for solids, but [model] has patches already; remove one", name));
  }
  for (const ConfigSection& attachment : sections(keys.attach, "model.attach"))
    model.attachments.push_back(read_attachment(attachment, {keys.length_unit}));
  return model;
}
}  // namespace isopatch::app
