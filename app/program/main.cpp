#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "app/commands/program.hpp"
#include "geometry/base/atomic_file.hpp"
#include "solvers/launch.hpp"
#include "solvers/processes.hpp"

int main(int count, char** arguments) {
  // Of several processes the first one alone writes files, and words.
  if (isopatch::solvers::launch().rank == 0) isopatch::remove_unfinished_files_on_interrupt();
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  const char* no_color = std::getenv("NO_COLOR");
  const bool colours = terminal && (no_color == nullptr || *no_color == '\0');
  const isopatch::app::Console console{std::cout, std::cerr, terminal, colours, false};
  return isopatch::app::run_program({arguments + 1, arguments + count}, console);
}
