#include "app/commands/info_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/base/engineering_units.hpp"
#include "app/commands/input_options.hpp"
#include "app/problem/block_file.hpp"
#include "app/problem/build_problem.hpp"
#include "app/problem/cut_solids.hpp"
#include "app/problem/loose_bodies.hpp"
#include "app/problem/reconstructed_solids.hpp"
#include "app/problem/t_joint_text.hpp"
#include "app/reports/describe_model.hpp"
#include "app/reports/describe_problem.hpp"
#include "app/solids/describe_solid.hpp"
#include "app/solids/describe_triangles.hpp"
#include "app/solids/solid_input.hpp"
#include "app/study/file_kind.hpp"
#include "app/study/parse_study.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "iga/coupling/well_posed.hpp"
#include "segmentation/decomposition/prospect.hpp"

namespace isopatch::app {
namespace {

constexpr const char* info_examples = R"(Examples:
  isopatch info model.xml                            G+Smo XML, GoTools .g2 or an MFEM NURBS mesh
  isopatch info model.xml --length-unit '225 mm'
  isopatch info study.toml                           its model, and where supports and loads are: a run without solving
  isopatch info study.toml --json | jq .volume
  isopatch info part.step                            a CAD solid: what is ready, what stands in the way
  isopatch info part.stl --length-unit mm            triangles: closed or not, which faces they make, how these would be cut
  isopatch info results/results.h5                   what a result file holds
Faces are named as in the file, so they can be copied into a study: faces = ["0:back"].)";

std::string heading(const InfoCommand& command, const LoadedInput& input) {
  const std::string path = command.input.path.string();
  if (!input.summary) return path + "\n";
  const RunSummary& run = *input.summary;
  return fmt::format(
      "{}: results of {}\nmax displacement {}, max von Mises {}, internal energy {}, {} unknowns\n", path,
      run.study.empty() ? "a study" : run.study, with_unit(run.max_displacement.value_or(0), "m"),
      with_unit(run.max_von_mises.value_or(0), "Pa"), with_unit(run.internal_energy.value_or(0), "J"),
      with_separators(run.unknowns));
}

/// Prints the report of each solid; fails after that if one is none.
ExitCode solid_info(const InfoCommand& command, const Console& console) {
  ProgressDisplay display(console);
  const LoadedSolids loaded = load_solids(command.input, display.progress());
  const std::vector<SolidReport>& solids = loaded.bodies;
  display.clear();
  for (const std::string& warning : loaded.warnings)
    console.warn(fmt::format("{}: {}", command.input.path.string(), warning));
  if (command.json) console.out << solids_json_text(solids, loaded.unit, loaded.warnings);
  if (!command.json)
    console.out << fmt::format("{}: {} {}, unit of length: {}\n", command.input.path.string(), solids.size(),
                               solids.size() == 1 ? "body" : "bodies", loaded.unit);
  const bool some_may_be_left =
      command.input.reading.allow_partial && std::any_of(solids.begin(), solids.end(), [](const auto& solid) {
        return solid.report.boundary.bounds_a_solid();
      });
  ExitCode code = ExitCode::ok;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const SolidReport& solid = solids[i];
    const std::string body = fmt::format("body {} '{}'", i, solid.file.name);
    if (!command.json)
      console.out << (solids.size() > 1 ? "\n" : "") << body << ": " << solid_text(solid, command.all);
    if (solid.report.stage != geometry::BrepStage::repair) continue;
    const std::string problem =
        fmt::format("{}: {}{}", command.input.path.string(), solids.size() > 1 ? body + ": " : "",
                    solid.report.findings.front());
    if (some_may_be_left && !solid.report.boundary.bounds_a_solid()) {
      console.warn(problem + "; other commands leave it out");
      continue;
    }
    console.fail(problem);
    code = ExitCode::wrong_input;
  }
  for (const std::string& missing : loaded.missing) {
    console.fail(fmt::format("{}: could not be read: {}", command.input.path.string(), missing));
    code = ExitCode::wrong_input;
  }
  return code;
}

/// Prints what triangles are and what would become of them; fails after that if no solid can be made of them.
ExitCode triangle_info(const InfoCommand& command, const Console& console) {
  ProgressDisplay display(console);
  const TriangleReport report = triangle_report(command.input, display.progress());
  display.clear();
  if (command.json)
    console.out << triangles_json_text(report);
  else
    console.out << fmt::format("{}: {}", command.input.path.string(), triangles_text(report));
  if (report.failure)
    throw Error(report.failure->code(),
                fmt::format("{}: {}", command.input.path.string(), report.failure->what()));
  return ExitCode::ok;
}

/// Prints what a file of blocks holds.
ExitCode block_info(const InfoCommand& command, const Console& console) {
  const segmentation::HexModel model = read_block_file(command.input.path).model;
  if (command.json)
    throw Error(ErrorCode::unsupported, "--json describes patches, solids and studies, not files of blocks");
  std::map<std::string, int> bodies;
  for (const std::string& body : model.bodies) ++bodies[body];
  console.out << fmt::format("{}: {}\n", command.input.path.string(), counted(model.solids.size(), "block"));
  for (const auto& [body, blocks] : bodies) console.out << fmt::format("  {}: {}\n", body, blocks);
  const std::vector<std::string> joints = t_joint_texts(model);
  console.out << (joints.empty()
                      ? "all meet side to side\n"
                      : fmt::format(
                            "{}, for studies with coupling.non_matching = \"nitsche\" or \"mortar\":\n",
                            counted(joints.size(), "T-joint")));
  for (const std::string& joint : joints) console.out << "  " << joint << "\n";
  return ExitCode::ok;
}

std::string whole_text(const geometry::MultiPatch& model, const ModelReport& seen, bool all) {
  std::string text = model_text(model, seen, all);
  for (const auto& face : model.degenerate_faces())
    text += fmt::format("collapsed face {}\n", model.label(face));
  return text;
}

/// The problem that a study describes, and why it cannot be solved if that is known before.
struct TriedStudy {
  std::optional<BuiltProblem> problem;
  std::optional<Error> refusal;
};

TriedStudy tried(const Study& study, const LoadedModel& loaded, const ModelReport& seen,
                 const Progress& progress) {
  TriedStudy result;
  try {
    result.problem = build_problem(study, loaded, seen, progress);
    warn_of_no_load(study, *result.problem);
    iga::require_well_posed(result.problem->problem, study.options.quadrature_points);
  } catch (const Error& error) {
    result.refusal = error;
  }
  return result;
}

/// What will be done with each solid, before it is.
std::string outlooks_text(const BlocksInput& input, const Progress& progress) {
  std::string text;
  for (const geometry::BrepFile& body : solids_of_files(input, progress).read.solids) {
    const geometry::RecognisedBrep found = geometry::recognise_carriers(body.brep);
    std::optional<segmentation::Prospect> prospect;
    if (!is_block(found.brep)) prospect = segmentation::prospect(found.brep, *input.decomposition);
    text += fmt::format("solid '{}': {}{}{}\n", body.name, found.text(), found.text().empty() ? "" : "; ",
                        outlook_text(prospect));
  }
  return text;
}

/// Prints the model, and where supports, loads and probes are; fails after that as a run would before it
/// solves: the model's faces are what a wrong selection is mended with.
ExitCode study_info(const InfoCommand& command, const Console& console) {
  ProgressDisplay display(console);
  const Study study = read_study(command.input.path, command.input.overrides);
  const std::string path = command.input.path.string() + "\n";
  const auto* solids = std::get_if<BlocksInput>(&study.model.source);
  const bool cuts = !command.json && solids && solids->decomposition;
  if (cuts) console.out << path << outlooks_text(*solids, display.progress());
  const LoadedModel loaded = load_model(study.model, display.progress());
  const geometry::MultiPatch& model = loaded.model;
  const ModelReport seen = report(model, display.progress());
  const TriedStudy study_tried = tried(study, loaded, seen, display.progress());
  display.clear();
  const auto& problem = study_tried.problem;
  if (command.json)
    console.out << model_json_text(model, seen, problem ? &*problem : nullptr);
  else
    console.out << (cuts ? "" : path) << whole_text(model, seen, command.all)
                << (problem ? problem_text(*problem, command.all) : "");
  for (const Warning& warning : problem ? problem->warnings : certificate_warnings(model, seen))
    console.warn(warning.text);
  if (study_tried.refusal) throw *study_tried.refusal;
  return ExitCode::ok;
}

}  // namespace

ExitCode info_command(const InfoCommand& command, const Console& console) {
  const FileKind kind = kind_of(command.input.path);
  if (holds_solids(kind)) return solid_info(command, console);
  if (kind == FileKind::triangles) return triangle_info(command, console);
  if (kind == FileKind::blocks) return block_info(command, console);
  if (kind == FileKind::study) return study_info(command, console);
  ProgressDisplay display(console);
  const LoadedInput input = load_input(command.input);
  const geometry::MultiPatch& model = input.model;
  const ModelReport seen = report(model, display.progress());
  display.clear();
  if (command.json)
    console.out << model_json_text(model, seen);
  else
    console.out << heading(command, input) << whole_text(model, seen, command.all);
  for (const Warning& warning : certificate_warnings(model, seen)) console.warn(warning.text);
  for (const Warning& warning : loose_body_warnings(model)) console.warn(warning.text);
  if (!input.result) {
    const iga::Discretization discretization = iga::discretize(model);
    if (!seen.certified()) iga::require_unfolded(discretization);
  }
  return ExitCode::ok;
}

void add_info_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<InfoCommand>();
  CLI::App& info =
      add_command(app, line, "info", "Describes a model, a study's model or a result file", info_examples,
                  [command](const Console& console) { return info_command(*command, console); });
  add_input(info, command->input);
  info.add_flag("--json", command->json, "JSON instead of text, complete, in SI units");
  info.add_flag("--all", command->all, "Long lists in full");
}

}  // namespace isopatch::app
