#include "app/commands/program.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <new>

#include "app/base/exit_code.hpp"
#include "app/base/provenance.hpp"
#include "app/commands/commands.hpp"
#include "app/results/summary.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"
#include "solvers/blas_core.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/cores.hpp"
#include "solvers/launch.hpp"
#include "solvers/process_failure.hpp"

namespace isopatch::app {
namespace {

constexpr const char* introduction = R"(isopatch: isogeometric analysis of solids made of NURBS patches.

A study is one file (TOML): where the patches come from, materials, supports, loads.
  isopatch run examples/link/study.toml              solve it; results beside the study
  isopatch info examples/link/study.toml             look at the model first: patches, faces, quality
  isopatch compare examples/link/study.toml          solve it with both couplings and compare
  isopatch probe results/results.h5 --point 0.1,0,0  values at a place, without solving again
  isopatch report results/results.h5                 the page about stored results: pictures, figures
  isopatch render results/results.h5 -o link.png     a picture of results or of a model
  isopatch keys                                      all keys of the study file)";

constexpr const char* exit_codes =
    R"(Exit codes: 0 done; 1 the run failed (supports, solver, memory, couplings that disagree);
2 wrong input or usage; 3 a file cannot be read or written; 130 interrupted (Ctrl-C),
143 terminated (kill, the end of a batch job's time).
Results go to standard output, progress and messages to standard error.)";

constexpr const char* run_examples = R"(Examples:
  isopatch run study.toml
  isopatch run study.toml --output /tmp/fine --set discretization.refine=2
  isopatch run study.toml --set load.0.traction='["20 MPa", 0, 0]' --set coupling.method=lagrange
  mpiexec -n 4 isopatch run study.toml               the same figures from four processes
  srun --mpi=pmix -n 4 -c 8 isopatch run study.toml  with Slurm, 8 threads each
  isopatch run study.toml --quiet && jq .results.internal_energy results/summary.json
Writes report.html (open it in a browser), summary.json, results.vtm and others with fields/ (ParaView) and
results.h5 (isopatch report, probe, fields, info).
Files appear whole or not at all, and only after everything has been computed.)";

constexpr const char* compare_examples = R"(Examples:
  isopatch compare study.toml
  isopatch compare study.toml --set discretization.degree=3
  isopatch compare study.toml --levels 3             as refined as the study, once more, twice more
  isopatch compare study.toml --levels 3 --degrees 2,3
  isopatch compare study.toml --condition            with condition numbers of both systems
Prints tables and writes compare.html (for a browser) and compare.json, anew after each level. Exit code 1 if the couplings differ at any
level by more than 1e-9 in displacement or energy, or 1e-8 in multipliers, relatively.)";

constexpr const char* info_examples = R"(Examples:
  isopatch info model.xml                            G+Smo XML, GoTools .g2 or an MFEM NURBS mesh
  isopatch info model.xml --length-unit '225 mm'
  isopatch info study.toml                           its model, and where supports and loads are: a run without solving
  isopatch info study.toml --json | jq .volume
  isopatch info part.step                            a CAD solid: what is ready, what stands in the way
  isopatch info results/results.h5                   what a result file holds
Faces are named as in the file, so they can be copied into a study: faces = ["0:back"].)";

constexpr const char* probe_examples = R"(Examples:
  isopatch probe results/results.h5 --point 0.1,0,0.02
  isopatch probe results/results.h5 --point '100 mm,0,20 mm' --json
  isopatch probe results/results.h5 --patch 3 --parameter .5,.5,1)";

constexpr const char* fields_examples = R"(Examples:
  isopatch fields results/results.h5 --output paraview
  isopatch fields results/results.h5 --output fine --pieces 8
Writes results.vtm (open it in ParaView; all filters work on it), results_boundaries.vtm and results_exact.vtm
(the smooth surface), with their parts in fields/.)";

constexpr const char* report_examples = R"(Examples:
  isopatch report results/results.h5                 writes results/report.html
  isopatch report results/results.h5 -o link.html
The page needs no network and no other file; isopatch run writes it too.)";

constexpr const char* render_examples = R"(Examples:
  isopatch render results/results.h5 -o link.png     von Mises stress on the deformed shape
  isopatch render results/results.h5 -o u.png --field displacement --component y --view front
  isopatch render results/results.h5 -o s.png --range '0,300 MPa' --deformation 1 --edges elements
  isopatch render results/results.h5 -o in.png --clip 'z=6 mm' --view top
  isopatch render study.toml -o model.png            the study's model, coloured by patch
  isopatch render study.toml -o held.png --field conditions    faces of its supports blue, of its loads red
  isopatch render part.step -o part.png              a CAD solid: convex edges dark, others red, flat ones grey
  isopatch render part.step -o graph.svg             its edge graph, drawn in the plane
  isopatch render parts.step -o one.png --solid 1    one of several solids; without --solid all of them
Without --range the colours span the values of 99.9 % of the surface (--percentile), so that a singular corner
does not take them all; the largest value stands below the bar. Needs an X display; where there is none, Xvfb
(Debian package xvfb) is started for the time of drawing.)";

constexpr const char* parameterize_examples = R"(Examples:
  isopatch parameterize block.step -o patches.xml
  isopatch parameterize part*.xml --pairs pairs.txt --length-unit '225 mm' -o patches.xml
  isopatch parameterize part*.xml -o patches.xml --tolerance 1e-5
Each solid must be a topological hexahedron: 8 vertices, 12 edges, 6 faces with four edges each. Prints how far the
patches are from the solids and how good they are. Exit code 1 if one is folded or deviates too far.)";

constexpr const char* convert_examples = R"(Examples:
  isopatch convert model.g2 --output model.xml
  isopatch convert part.mesh --output part.xml)";

constexpr const char* verify_examples = R"(Examples:
  isopatch verify                                    all quick suites
  isopatch verify closed_forms published             some
  isopatch verify --level full                       everything; takes long
Prints one table and writes verify.json and verify.html. Exit code 1 if a claim fails; the study or test
that shows it alone is named.)";

constexpr const char* keys_examples = R"(Examples:
  isopatch keys                 everything, as Markdown
  isopatch keys support         one section, or the sections with a key of that name)";

ExitCode exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::io:
      return ExitCode::file_problem;
    case ErrorCode::invalid_argument:
    case ErrorCode::bad_format:
    case ErrorCode::unsupported:
    case ErrorCode::not_conforming:
    case ErrorCode::not_manifold:
    case ErrorCode::not_contractible:
    case ErrorCode::not_three_connected:
    case ErrorCode::fold_over:
      return ExitCode::wrong_input;
    default:
      return ExitCode::failed;
  }
}

/// The options of all commands, before parsing has said which one was named.
struct CommandLine {
  StudyCommand study;
  LevelOptions levels;
  InfoCommand info;
  ProbeCommand probe;
  FieldsCommand fields;
  ReportCommand report;
  RenderCommand render;
  ConvertCommand convert;
  ParameterizeCommand parameterize;
  VerifyCommand verify;
  std::string topic;
  std::string output;  ///< of run and compare
  std::string level = "quick";
  std::string report_output;
  bool quiet = false;
  int threads = 0;
  std::function<ExitCode(const Console&)> action;
};

CLI::App* add_command(CLI::App& app, CommandLine& line, const std::string& name, const std::string& meaning,
                      const char* examples, std::function<ExitCode(const Console&)> action) {
  CLI::App* command = app.add_subcommand(name, meaning);
  command->footer(examples);
  command->add_flag("-q,--quiet", line.quiet, "No progress, no summary; only warnings and errors");
  command
      ->add_option("--threads", line.threads,
                   "Number of threads of each process; 0: all cores that it may use")
      ->check(CLI::Range(0, 4096));
  command->callback([&line, action = std::move(action)] { line.action = action; });
  return command;
}

void add_study_commands(CLI::App& app, CommandLine& line) {
  const auto common = [&line](CLI::App* command) {
    command->add_option("study", line.study.study, "The study file (TOML)")->required();
    command->add_option("--set", line.study.overrides, "Replaces a key: --set discretization.refine=2")
        ->take_all()
        ->expected(1)
        ->type_name("KEY=VALUE");
    command->add_option("-o,--output", line.output, "Directory of the results")->type_name("DIR");
  };
  const auto with_output = [&line] {
    if (!line.output.empty()) line.study.output = line.output;
    return line.study;
  };
  common(add_command(app, line, "run", "Solves a study and writes its results", run_examples,
                     [with_output](const Console& console) { return run_command(with_output(), console); }));
  CLI::App* compare =
      add_command(app, line, "compare", "Solves a study with both couplings and compares them",
                  compare_examples, [with_output, &line](const Console& console) {
                    return compare_command(with_output(), line.levels, console);
                  });
  common(compare);
  compare
      ->add_option("--levels", line.levels.count,
                   "Compares at discretization.refine, one more, ...: N levels")
      ->check(CLI::Range(1, 11))
      ->type_name("N");
  compare->add_option("--degrees", line.levels.degrees, "Compares all levels with each of these degrees: 2,3")
      ->delimiter(',')
      ->expected(1, 10)
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 10))
      ->type_name("P,P");
  compare->add_flag(
      "--condition", line.levels.condition,
      "Estimates the condition of systems that are factorized, which takes some thirty solutions more");
}

void add_reading(CLI::App* command, CadReading& reading) {
  command->add_flag("--allow-partial", reading.allow_partial,
                    "Bodies and faces of CAD files that cannot be read are a warning and left out");
  command
      ->add_option("--cad-time-limit", reading.time_limit,
                   "Seconds that a CAD file may take to be read; default: 60, and 10 for each MB")
      ->check(CLI::PositiveNumber)
      ->type_name("S");
  command
      ->add_option("--cad-memory-limit", reading.memory_limit,
                   "Bytes that a CAD file may take to be read; default: three quarters of the memory")
      ->check(CLI::PositiveNumber)
      ->type_name("BYTES");
}

void add_input(CLI::App* command, InputFile& input) {
  command
      ->add_option(
          "input", input.path,
          "Patches (.xml, .g2, .mesh), a solid (.step, .iges, .brep, .xml, .off), a study (.toml) or "
          "results (.h5)")
      ->required();
  command->add_option("--set", input.overrides, "Replaces a key of the study")
      ->take_all()
      ->expected(1)
      ->type_name("KEY=VALUE");
  command->add_option("--length-unit", input.length_unit,
                      "What one unit of the file measures [m]; STEP and IGES files say it themselves");
  add_reading(command, input.reading);
}

void add_render_command(CLI::App& app, CommandLine& line) {
  CLI::App* render =
      add_command(app, line, "render", "Draws a model or results as a picture", render_examples,
                  [&line](const Console& console) { return render_command(line.render, console); });
  PictureWords& words = line.render.words;
  const auto option = [&](const char* name, auto& target, const char* meaning, const char* type) {
    return render->add_option(name, target, meaning)->type_name(type);
  };
  add_input(render, line.render.input);
  option("-o,--output", line.render.output, "The picture (.png), or of a solid's edge graph (.svg)", "FILE")
      ->required();
  option("--field", words.field,
         "von_mises, displacement, patch, jacobian, conditions (supports and loads of a study) or none; "
         "default: "
         "von_mises for results, else patch",
         "NAME");
  option("--component", words.component, "x, y or z of the displacement; default: its length", "AXIS");
  option("--range", words.range, "The values of the first and the last colour, SI or with units", "LOW,HIGH");
  option("--percentile", words.percentile, "How much of the surface the range holds without --range, %", "P")
      ->capture_default_str();
  option("--deformation", words.deformation, "Factor of the displacement in the picture; auto: well visible",
         "FACTOR")
      ->capture_default_str();
  option("--view", words.view,
         "iso, front, back, left, right, top, bottom, or X,Y,Z from the part to the eye", "VIEW")
      ->capture_default_str();
  option("--up", words.up, "What points upwards: x, y, z or X,Y,Z; default: z, along z y", "AXIS");
  option("--zoom", words.zoom, "Above 1: larger than the picture", "F")->capture_default_str();
  option("--size", words.size, "Pixels", "WxH")->capture_default_str();
  option("--edges", words.edges, "Lines: patches, elements or none", "NAME")->capture_default_str();
  option("--clip", words.clip, "Cuts the undeformed part: 'x=20 mm' keeps what lies below", "AXIS=POSITION");
  option("--solid", line.render.solid, "Draws one solid of a file with several, from 0 as info counts them",
         "N");
  option("--caption", words.caption, "Instead of title and deformation; '' for none", "TEXT");
  render->add_flag("--transparent-background", words.transparent, "No white behind the part");
  render->add_flag("--no-bar", words.no_bar, "No colour bar");
}

void add_parameterize_command(CLI::App& app, CommandLine& line) {
  ParameterizeCommand& command = line.parameterize;
  CLI::App* parameterize =
      add_command(app, line, "parameterize", "Makes patches of solids that are topological hexahedra",
                  parameterize_examples,
                  [&command](const Console& console) { return parameterize_command(command, console); });
  parameterize
      ->add_option("blocks", command.blocks,
                   "Solids: .step, .stp, .p21, .iges, .igs, .brep, .brp, .xml (G+Smo), .off")
      ->required();
  parameterize->add_option("-o,--output", command.output, "The patches (.xml)")
      ->required()
      ->type_name("FILE");
  parameterize
      ->add_option("--report", command.report,
                   "A page with the patches by quality and deviation, or with what is wrong with the solids")
      ->type_name("FILE");
  parameterize->add_option("--pairs", command.pairs, "How blocks meet; default: found from the geometry")
      ->type_name("FILE");
  parameterize->add_option("--length-unit", command.length_unit,
                           "What one unit measures, in formats that do not say it; default: m");
  add_reading(parameterize, command.reading);
  parameterize
      ->add_option("--tolerance", command.input.options.fit.tolerance,
                   "Largest deviation, share of the size, 1e-8 to 0.1")
      ->capture_default_str();
  segmentation::FitOptions& fit = command.input.options.fit;
  parameterize->add_option("--degree", fit.degree, "Of the patches, 2 to 8")->capture_default_str();
  parameterize
      ->add_option("--max-spans", fit.max_spans,
                   "Most knot spans along any direction of a patch, up to 1024; eight times the spans that "
                   "the solid's own splines or turns ask for if that is more")
      ->capture_default_str();
  parameterize
      ->add_option("--start-spans", fit.start_spans, "Knot spans along every direction before any is halved")
      ->capture_default_str();
  parameterize
      ->add_option("--wanted-quality", command.input.options.wanted_quality,
                   "Patches whose smallest scaled Jacobian is below it are optimized")
      ->capture_default_str();
  parameterize->add_flag("!--no-optimize", command.input.options.optimize,
                         "Moves no control points where a patch is folded or poor, only reports it");
  parameterize
      ->add_option("--same-point", command.input.files.assembly.same_point,
                   "Points of two blocks this close, as a share of the size, are one")
      ->capture_default_str();
  parameterize->add_option("--method", command.method, "shared, or paper for comparison")
      ->check(CLI::IsMember({"shared", "paper"}))
      ->capture_default_str();
}

void add_file_commands(CLI::App& app, CommandLine& line) {
  CLI::App* info =
      add_command(app, line, "info", "Describes a model, a study's model or a result file", info_examples,
                  [&line](const Console& console) { return info_command(line.info, console); });
  add_input(info, line.info.input);
  info->add_flag("--json", line.info.json, "JSON instead of text, complete, in SI units");
  info->add_flag("--all", line.info.all, "Long lists in full");

  CLI::App* probe =
      add_command(app, line, "probe", "Values at a place of stored results", probe_examples,
                  [&line](const Console& console) { return probe_command(line.probe, console); });
  probe->add_option("results", line.probe.results, "A results.h5")->required();
  probe->add_option("--point", line.probe.point, "A place X,Y,Z in m, or with units")->type_name("X,Y,Z");
  probe->add_option("--patch", line.probe.patch, "A patch, from 0")->type_name("N");
  probe->add_option("--parameter", line.probe.parameter, "A parameter of that patch")->type_name("A,B,C");
  probe->add_flag("--json", line.probe.json, "JSON instead of text");

  CLI::App* fields =
      add_command(app, line, "fields", "Writes the fields of stored results for ParaView", fields_examples,
                  [&line](const Console& console) { return fields_command(line.fields, console); });
  fields->add_option("results", line.fields.results, "A results.h5")->required();
  fields->add_option("-o,--output", line.fields.output, "Directory for results.vtm and fields/")
      ->required()
      ->type_name("DIR");
  fields
      ->add_option("--pieces", line.fields.pieces,
                   "Straight hexahedra per element and direction (default: 4, fewer in large models)")
      ->check(CLI::Range(1, 32))
      ->type_name("N");

  CLI::App* report = add_command(app, line, "report", "Writes the page about stored results", report_examples,
                                 [&line](const Console& console) {
                                   if (!line.report_output.empty()) line.report.output = line.report_output;
                                   return report_command(line.report, console);
                                 });
  report->add_option("results", line.report.results, "A results.h5")->required();
  report->add_option("-o,--output", line.report_output, "The page (default: report.html beside the results)")
      ->type_name("FILE");

  add_render_command(app, line);
  add_parameterize_command(app, line);

  CLI::App* convert =
      add_command(app, line, "convert", "Writes patches as G+Smo XML", convert_examples,
                  [&line](const Console& console) { return convert_command(line.convert, console); });
  convert->add_option("input", line.convert.input, "Patches (.xml, .g2, .mesh)")->required();
  convert->add_option("-o,--output", line.convert.output, "The new file (.xml)")
      ->required()
      ->type_name("FILE");

  CLI::App* verify = add_command(app, line, "verify", "Checks what isopatch claims against reference results",
                                 verify_examples, [&line](const Console& console) {
                                   line.verify.full = line.level == "full";
                                   return verify_command(line.verify, console);
                                 });
  verify->add_option("suites", line.verify.suites, "Names of suites (default: all of the level)");
  verify->add_option("--level", line.level, "quick takes minutes, full as long as it needs")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  verify->add_flag("--list", line.verify.list, "Only the names of the suites");
  verify->add_option("-o,--output", line.verify.output, "Directory of verify.json and verify.html")
      ->type_name("DIR")
      ->capture_default_str();

  CLI::App* keys = add_command(app, line, "keys", "Documents the keys of the study file", keys_examples,
                               [&line](const Console& console) { return keys_command(line.topic, console); });
  keys->add_option("topic", line.topic, "A section or a key, for example support");
}

/// The program's, and the core whose kernels the BLAS uses: a wrong one costs factorizations most of their
/// speed.
std::string versions() {
  const std::string core = solvers::blas_core();
  return fmt::format("isopatch {}\nBLAS: {}", version(),
                     core.empty() ? "not OpenBLAS" : "OpenBLAS for " + core);
}

std::unique_ptr<CLI::App> make_parser(CommandLine& line) {
  auto app = std::make_unique<CLI::App>(introduction, "isopatch");
  app->footer(exit_codes);
  app->set_version_flag("--version", [] { return versions(); });
  app->require_subcommand(1);
  add_study_commands(*app, line);
  add_file_commands(*app, line);
  return app;
}

/// Says what went wrong, one process for all, and gives back the exit code.
ExitCode fail(const solvers::Processes& processes, const Console& console, ExitCode code,
              const std::string& message) {
  solvers::ProcessFailure failure(processes);
  if (failure.is_to_report()) console.fail(message);
  failure.leave_or_abort(static_cast<int>(code));
  return code;
}

/// Standard output may be a file on a full disk. One that is closed, as of silent processes, is no fault.
/// @throws Error io
void require_written(std::ostream& out) {
  if (out.rdbuf() == nullptr) return;
  errno = 0;
  out.flush();
  if (out.good()) return;
  throw Error(ErrorCode::io, fmt::format("cannot write to standard output{}; what is there is not complete",
                                         errno ? fmt::format(": {}", std::strerror(errno)) : ""));
}

/// @param console  of this process, silent but on the first
/// @param loud     for what ends the run
ExitCode act(const CommandLine& line, const Console& console, const Console& loud) {
  const solvers::Processes& processes = line.study.processes;
  try {
    const ExitCode code = line.action(console);
    require_written(console.out);
    processes.barrier();  // the first one may still fail to write
    return code;
  } catch (const Error& error) {
    return fail(processes, loud, exit_code(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return fail(processes, loud, ExitCode::failed,
                "out of memory; refine less, lower the degree, or use a machine with more memory");
  } catch (const std::exception& error) {
    return fail(processes, loud, ExitCode::failed,
                fmt::format("this is a bug in isopatch, please report it with the input that caused it: {}",
                            error.what()));
  }
}

/// What to say of threads that outnumber the cores; empty if they do not.
std::string crowd_warning(const solvers::Crowd& crowd) {
  if (!crowd.is_too_large()) return "";
  const int fair = std::max(1, crowd.cores / crowd.processes);
  const std::string cores = fmt::format("{} core{}", crowd.cores, crowd.cores == 1 ? "" : "s");
  if (crowd.processes == 1)
    return fmt::format("{} threads on {}: they take turns, which is slower than --threads {}", crowd.threads,
                       cores, fair);
  return fmt::format(
      "{} processes with {} threads in all on {} of one computer: they take turns, which is slower than "
      "fewer; give "
      "them more cores (mpiexec --bind-to none, srun -c THREADS) or use --threads {}",
      crowd.processes, crowd.threads, cores, fair);
}

/// As many as were asked for, else as the environment says, else an even share of the cores that this and the
/// other processes on the computer may use. All processes must call it.
void set_threads(int asked, const solvers::Processes& processes, const Console& console) {
  if (asked > 0)
    omp_set_num_threads(asked);
  else if (processes.count() > 1 && !std::getenv("OMP_NUM_THREADS"))
    omp_set_num_threads(processes.fair_threads(omp_get_max_threads()));
  // Threads of OpenMP regions would otherwise multiply with those of the BLAS; factorizations raise it again.
  solvers::set_blas_threads(1);
  const std::string warning = crowd_warning(solvers::largest_crowd(processes, omp_get_max_threads()));
  if (!warning.empty() && processes.is_first()) console.warn(warning);
}

/// Exit code of what has only printed.
ExitCode finished(const Console& console) {
  try {
    require_written(console.out);
    return ExitCode::ok;
  } catch (const Error& error) {
    console.fail(error.what());
    return exit_code(error.code());
  }
}

/// The whole program on one of the launched processes.
/// @param console  silent but on the first one
int run_on_process(const std::vector<std::string>& arguments, const Console& console, const Console& loud) {
  CommandLine line;
  const auto app = make_parser(line);
  try {
    // CLI11 takes its arguments from the back.
    app->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success& request) {
    app->exit(request, console.out, console.err);
    return static_cast<int>(finished(console));
  } catch (const CLI::ParseError& error) {
    const auto chosen = app->get_subcommands();
    if (chosen.empty() && !arguments.empty() && !arguments.front().starts_with('-')) {
      std::vector<std::string> commands;
      for (const CLI::App* command : app->get_subcommands({})) commands.push_back(command->get_name());
      console.fail(fmt::format("unknown command '{}'{}; see isopatch --help", arguments.front(),
                               did_you_mean(arguments.front(), commands)));
      return static_cast<int>(ExitCode::wrong_input);
    }
    console.fail(fmt::format("{}; see isopatch {}--help", error.what(),
                             chosen.empty() ? "" : chosen.front()->get_name() + " "));
    return static_cast<int>(ExitCode::wrong_input);
  }
  try {
    // Only solving is spread.
    if (!line.study.study.empty())
      line.study.processes = solvers::Processes::launched();
    else if (solvers::launch().rank > 0)
      return static_cast<int>(ExitCode::ok);
  } catch (const Error& error) {
    console.fail(error.what());
    return static_cast<int>(exit_code(error.code()));
  }
  set_threads(line.threads, line.study.processes, console);
  Console chosen = console;
  chosen.quiet = chosen.quiet || line.quiet;
  return static_cast<int>(act(line, chosen, loud));
}

}  // namespace

int run_program(const std::vector<std::string>& arguments, const Console& console) {
  if (solvers::launch().rank == 0) return run_on_process(arguments, console, console);
  // The first process' exit code is the program's: with another one, the launcher could end the first before
  // it has spoken. What this process alone fails at has ended all before it comes here.
  std::ostream nowhere(nullptr);
  run_on_process(arguments, {nowhere, nowhere, false, false, true}, console);
  return static_cast<int>(ExitCode::ok);
}

}  // namespace isopatch::app
