#include "app/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <utility>

namespace isopatch::app {
namespace {

CLI::App& with_common_options(CLI::App& command, CommandLine& line, const char* examples) {
  command.footer(examples);
  command.add_flag("-q,--quiet", line.quiet, "No progress, no summary; only warnings and errors");
  command
      .add_option("--threads", line.threads,
                  "Number of threads of each process; 0: all cores that it may use")
      ->check(CLI::Range(0, 4096));
  return command;
}

}  // namespace

CLI::App& add_command(CLI::App& app, CommandLine& line, const std::string& name, const std::string& meaning,
                      const char* examples, std::function<ExitCode(const Console&)> action) {
  CLI::App& command = with_common_options(*app.add_subcommand(name, meaning), line, examples);
  command.callback([&line, action = std::move(action)] {
    line.action = [action](const Console& console, const solvers::Processes&) { return action(console); };
  });
  return command;
}

CLI::App& add_spread_command(CLI::App& app, CommandLine& line, const std::string& name,
                             const std::string& meaning, const char* examples,
                             std::function<ExitCode(const Console&, const solvers::Processes&)> action) {
  CLI::App& command = with_common_options(*app.add_subcommand(name, meaning), line, examples);
  command.callback([&line, action = std::move(action)] {
    line.action = action;
    line.is_spread = true;
  });
  return command;
}

}  // namespace isopatch::app
