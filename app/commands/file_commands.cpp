#include <fmt/format.h>

#include <algorithm>

#include "app/base/engineering_units.hpp"
#include "app/base/exit_code.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/commands/commands.hpp"
#include "app/problem/loose_bodies.hpp"
#include "app/problem/read_model_file.hpp"
#include "app/reports/describe_model.hpp"
#include "app/reports/describe_problem.hpp"
#include "app/reports/report_page.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/stored_results.hpp"
#include "app/results/write_fields.hpp"
#include "app/solids/solid_input.hpp"
#include "app/study/solid_file.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/io/write_gismo_xml.hpp"
#include "iga/coupling/well_posed.hpp"

namespace isopatch::app {
namespace {

std::string heading(const InfoCommand& command, const LoadedInput& input) {
  const std::string path = command.input.path.string();
  if (!input.result) return path + "\n";
  const Json summary = Json::parse(input.result->summary, nullptr, false);
  if (summary.is_discarded()) return path + "\n";
  std::string text = path + ": results of " + summary.value("study", "a study") + "\n";
  const auto number = [&](const char* place) { return summary.value(Json::json_pointer(place), 0.0); };
  text += fmt::format("max displacement {}, max von Mises {}, internal energy {}, {} unknowns\n",
                      with_unit(number("/results/max_displacement"), "m"),
                      with_unit(number("/results/max_von_mises"), "Pa"),
                      with_unit(number("/results/internal_energy"), "J"),
                      with_separators(static_cast<std::int64_t>(number("/discretization/dofs"))));
  return text;
}

std::string values_text(const StoredValues& found) {
  const iga::FieldValues& v = found.values;
  const auto tidy = [](const Eigen::Vector3d& x) { return without_round_off(x, x.cwiseAbs().maxCoeff()); };
  const Eigen::Vector3d place = tidy(v.place);
  const Eigen::Vector3d displacement = tidy(v.displacement);
  const auto stress = [&](int i, int j) {
    return without_round_off(v.stress(i, j), v.stress.cwiseAbs().maxCoeff());
  };
  return fmt::format(
      "point         ({:.9g}, {:.9g}, {:.9g}) m, patch {}, parameter ({:.6g}, {:.6g}, {:.6g})\n"
      "displacement  ({:.9g}, {:.9g}, {:.9g}) m\n"
      "stress        xx {:.6g}, yy {:.6g}, zz {:.6g}, xy {:.6g}, yz {:.6g}, zx {:.6g} Pa\n"
      "von Mises     {:.6g} Pa\n",
      place[0], place[1], place[2], found.patch, found.parameter[0], found.parameter[1], found.parameter[2],
      displacement[0], displacement[1], displacement[2], stress(0, 0), stress(1, 1), stress(2, 2),
      stress(0, 1), stress(1, 2), stress(2, 0), v.von_mises);
}

std::string values_json(const StoredValues& found) {
  return file_text({{"patch", found.patch},
                    {"parameter", to_json(Eigen::Vector3d(found.parameter))},
                    {"point", to_json(found.values.place)},
                    {"displacement", to_json(found.values.displacement)},
                    {"strain", symmetric_to_json(found.values.strain)},
                    {"stress", symmetric_to_json(found.values.stress)},
                    {"von_mises", found.values.von_mises},
                    {"jacobian", found.values.jacobian}});
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
    iga::require_well_posed(result.problem->problem, study.options.quadrature_points);
  } catch (const Error& error) {
    result.refusal = error;
  }
  return result;
}

/// Prints the model, and where supports, loads and probes are; fails after that as a run would before it
/// solves: the model's faces are what a wrong selection is mended with.
ExitCode study_info(const InfoCommand& command, const Console& console) {
  ProgressDisplay display(console);
  const Study study = read_study(command.input.path, command.input.overrides);
  const LoadedModel loaded = load_model(study.model, display.progress());
  const geometry::MultiPatch& model = loaded.model;
  const ModelReport seen = report(model, display.progress());
  const TriedStudy study_tried = tried(study, loaded, seen, display.progress());
  display.clear();
  const auto& problem = study_tried.problem;
  if (command.json)
    console.out << model_json_text(model, seen, problem ? &*problem : nullptr);
  else
    console.out << command.input.path.string() << "\n"
                << whole_text(model, seen, command.all)
                << (problem ? problem_text(*problem, command.all) : "");
  for (const Warning& warning : problem ? problem->warnings : certificate_warnings(model, seen))
    console.warn(warning.text);
  if (study_tried.refusal) throw *study_tried.refusal;
  return ExitCode::ok;
}

}  // namespace

ExitCode info_command(const InfoCommand& command, const Console& console) {
  if (is_solid_file(command.input.path)) return solid_info(command, console);
  if (command.input.path.extension() == ".toml") return study_info(command, console);
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

ExitCode probe_command(const ProbeCommand& command, const Console& console) {
  if (command.point.empty() == !command.patch.has_value() ||
      command.patch.has_value() == command.parameter.empty())
    throw Error(ErrorCode::invalid_argument,
                "give either --point X,Y,Z, or --patch N with --parameter A,B,C");
  StoredProbe where;
  if (!command.point.empty()) where.point = parse_point(command.point);
  where.patch = command.patch;
  if (!command.parameter.empty()) where.parameter = parse_parameter(command.parameter);
  const StoredValues found = probe(iga::read_result(command.results), where);
  console.out << (command.json ? values_json(found) : values_text(found));
  return ExitCode::ok;
}

ExitCode fields_command(const FieldsCommand& command, const Console& console) {
  const OutputFolder folder(command.output);
  ProgressDisplay display(console);
  const iga::StoredResult result = iga::read_result(command.results);
  const geometry::MultiPatch model = iga::model_of(result);
  const WrittenFields written = write_fields(result.field, model, face_groups(model, result.summary),
                                             {.pieces = command.pieces}, command.output, display.progress());
  display.clear();
  if (const auto warning = borrowed_warning(written.borrowed, model.size())) console.warn(warning->text);
  if (!console.quiet)
    console.out << fmt::format("{} files in {}; open results.vtm in ParaView\n", written.files,
                               command.output.string());
  return ExitCode::ok;
}

ExitCode report_command(const ReportCommand& command, const Console& console) {
  const auto path = command.output.value_or(command.results.parent_path() / "report.html");
  check_writable(path.parent_path().empty() ? "." : path.parent_path());
  ProgressDisplay display(console);
  const auto progress = display.progress();
  progress("reading the results", 0);
  const iga::StoredResult result = iga::read_result(command.results);
  progress("making the report", 0);
  write_file(path, report_html(result.field, iga::model_of(result), result.study, result.summary));
  display.clear();
  if (!console.quiet) console.out << fmt::format("{} written; open it in a browser\n", path.string());
  return ExitCode::ok;
}

ExitCode convert_command(const ConvertCommand& command, const Console& console) {
  const geometry::MultiPatch model = geometry::connect(read_model_file(command.input, false));
  write_file(command.output, geometry::to_gismo_xml(model));
  if (!console.quiet)
    console.out << fmt::format("{} patches, {} interfaces written to {}\n", model.patch_count(),
                               model.interfaces().size(), command.output.string());
  return ExitCode::ok;
}

}  // namespace isopatch::app
