#pragma once

#include <functional>
#include <string>

#include "app/base/exit_code.hpp"
#include "app/commands/console.hpp"
#include "solvers/processes.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace isopatch::app {

/// What a command line asks for, once it is known which command it names.
struct CommandLine {
  std::function<ExitCode(const Console&, const solvers::Processes&)> action;
  bool is_spread = false;  ///< whether all launched processes carry it out together, or the first alone
  bool quiet = false;
  int threads = 0;  ///< of each process; 0: as many as it may use
};

/// Adds a command with the options that all have. Where it is chosen, its action becomes that of the line.
/// @param examples  end of its help
CLI::App& add_command(CLI::App& app, CommandLine& line, const std::string& name, const std::string& meaning,
                      const char* examples, std::function<ExitCode(const Console&)> action);
/// The same for a command that all launched processes carry out together.
CLI::App& add_spread_command(CLI::App& app, CommandLine& line, const std::string& name,
                             const std::string& meaning, const char* examples,
                             std::function<ExitCode(const Console&, const solvers::Processes&)> action);

}  // namespace isopatch::app
