#include "app/commands/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <memory>
#include <new>

#include "app/base/exit_code.hpp"
#include "app/base/provenance.hpp"
#include "app/commands/compare_command.hpp"
#include "app/commands/convert_command.hpp"
#include "app/commands/fields_command.hpp"
#include "app/commands/info_command.hpp"
#include "app/commands/keys_command.hpp"
#include "app/commands/modes_command.hpp"
#include "app/commands/parameterize_command.hpp"
#include "app/commands/probe_command.hpp"
#include "app/commands/reconstruct_command.hpp"
#include "app/commands/render_command.hpp"
#include "app/commands/report_command.hpp"
#include "app/commands/run_command.hpp"
#include "app/commands/segment_command.hpp"
#include "app/commands/threads.hpp"
#include "app/commands/verify_command.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"
#include "solvers/blas_core.hpp"
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
  for (const auto& add : {add_run_command, add_compare_command, add_modes_command, add_info_command,
                          add_probe_command, add_fields_command, add_report_command, add_render_command,
                          add_reconstruct_command, add_segment_command, add_parameterize_command,
                          add_convert_command, add_verify_command, add_keys_command})
    add(*app, line);
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
ExitCode act(const CommandLine& line, const solvers::Processes& processes, const Console& console,
             const Console& loud) {
  try {
    const ExitCode code = line.action(console, processes);
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
  solvers::Processes processes;
  try {
    if (line.is_spread)
      processes = solvers::Processes::launched();
    else if (solvers::launch().rank > 0)
      return static_cast<int>(ExitCode::ok);
  } catch (const Error& error) {
    console.fail(error.what());
    return static_cast<int>(exit_code(error.code()));
  }
  set_threads(line.threads, processes, console);
  Console chosen = console;
  chosen.quiet = chosen.quiet || line.quiet;
  return static_cast<int>(act(line, processes, chosen, loud));
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
